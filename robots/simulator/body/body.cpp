// SPDX-License-Identifier: MIT
#include "robots/simulator/body/body.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/gravity.h"
#include "geometry/pinned_math.h"
#include "geometry/transform.h"

namespace reorient {
namespace {

double finite(double value) { return std::isfinite(value) ? value : 0.0; }

double toward(double from, double to, double most) { return from + std::clamp(to - from, -most, most); }

/// From 0 to 1, with a soft start and end.
double ease(double fraction) {
  const double s = std::clamp(fraction, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

}  // namespace

BodyParameters body_parameters_of(const RobotBody& body) {
  BodyParameters parameters;
  const Gait gait = body.gait.value_or(Gait{.forward = 0.0, .left = 0.0, .turn = 0.0});
  parameters.forward_limit = gait.forward;
  parameters.left_limit = gait.left;
  parameters.turn_limit = gait.turn;
  parameters.head_speed_limit = body.head_speed;
  parameters.step_frequency = gait.step_frequency;
  parameters.sway_roll = gait.sway_roll;
  parameters.sway_pitch = gait.sway_pitch;
  parameters.sway_height = gait.sway_height;
  parameters.get_up_time = body.get_up_time.value_or(parameters.get_up_time);
  parameters.foot_sensors = body.standing_load.has_value();
  return parameters;
}

Body::Body(const BodyParameters& parameters, const RobotBody& robot, const Pose2& start, std::uint64_t seed)
    : parameters_(parameters),
      robot_(robot),
      random_(seed, 0xb0d7),
      pose_(start),
      torso_height_(robot.dimensions.torso_height) {
  const double scale = parameters_.odometry_scale_error;
  odometry_scale_ = {1.0 + scale * random_.normal(), 1.0 + scale * random_.normal(), 1.0 + scale * random_.normal()};
  odometry_drift_ = parameters_.odometry_turn_bias * random_.normal();
  attitude_bias_ = {parameters_.roll_offset + parameters_.attitude_bias * random_.normal(),
                    parameters_.pitch_offset + parameters_.attitude_bias * random_.normal()};
  for (double& bias : accelerometer_bias_) bias = parameters_.accelerometer_bias * random_.normal();
}

void Body::advance(double time_step, const Request& request, std::span<const Barrier> barriers,
                   const Eigen::Vector2d& bounds) {
  since_ += time_step;
  move_head(time_step, request);
  walk(time_step, request);
  balance(time_step, request.get_up);
  if (posture_ != Posture::carried) collide(barriers, bounds);
  feel(time_step);
}

void Body::pick_up() {
  if (posture_ == Posture::carried) return;
  const bool is_upright = posture_ == Posture::upright;
  posture_ = Posture::carried;
  since_ = 0.0;
  velocity_ = {};
  hands_ = {};
  hands_.height = parameters_.carry_height * random_.uniform(0.6, 1.4);
  hands_.raise_time = random_.uniform(0.6, 1.3);
  hands_.lower_time = parameters_.lower_time * random_.uniform(0.7, 1.5);
  hands_.sway = random_.uniform(0.5, 1.3);
  hands_.pace = random_.uniform(0.7, 1.3);
  if (is_upright) return;  // a lift ends the sway of the walk at once
  hands_.below = robot_.dimensions.torso_height - torso_height_;
  hands_.tilt = torso_;
}

void Body::put_down(const Pose2& where) {
  pose_ = where;
  last_moment_.reset();
  last_velocity_.reset();
  if (posture_ != Posture::carried || hands_.lower_time <= 0.0) return set_down();
  hands_.lowered_since = since_;
  hands_.held_at = torso_height_;
}

/// Ends the lift: the feet are on the ground.
void Body::set_down() {
  posture_ = Posture::upright;
  since_ = 0.0;
  velocity_ = {};
  torso_ = {};
  effort_ = 0.0;
  torso_height_ = robot_.dimensions.torso_height;
}

void Body::push_over() {
  if (posture_ != Posture::upright) return;
  posture_ = Posture::falling;
  since_ = 0.0;
  velocity_ = {};
  // On its face, on its back, or sometimes on a side.
  constexpr double kDown = 1.52;
  const double direction = random_.uniform();
  if (direction < 0.4) {
    lying_ = {0.0, kDown};
  } else if (direction < 0.8) {
    lying_ = {0.0, -kDown};
  } else {
    lying_ = {direction < 0.9 ? kDown : -kDown, 0.0};
  }
}

void Body::move_head(double time_step, const Request& request) {
  if (!request.head) return;
  const double requested_speed = finite(request.head->speed);
  const double most = std::clamp(requested_speed, 0.0, parameters_.head_speed_limit) * time_step;
  const HeadAngles requested =
      robot_.neck.clamp({finite(request.head->angles.yaw), finite(request.head->angles.pitch)});
  head_ = robot_.neck.clamp({toward(head_.yaw, requested.yaw, most), toward(head_.pitch, requested.pitch, most)});
}

void Body::walk(double time_step, const Request& request) {
  if (posture_ != Posture::upright) return;
  WalkVelocity requested;
  if (!penalized_) {
    requested.forward = std::clamp(finite(request.walk.forward), -parameters_.forward_limit, parameters_.forward_limit);
    requested.left = std::clamp(finite(request.walk.left), -parameters_.left_limit, parameters_.left_limit);
    requested.turn = std::clamp(finite(request.walk.turn), -parameters_.turn_limit, parameters_.turn_limit);
  }
  velocity_.forward = toward(velocity_.forward, requested.forward, parameters_.acceleration * time_step);
  velocity_.left = toward(velocity_.left, requested.left, parameters_.acceleration * time_step);
  velocity_.turn = toward(velocity_.turn, requested.turn, parameters_.turn_acceleration * time_step);

  // Along the arc: half of the turn before the translation, half after it.
  const double turn = velocity_.turn * time_step;
  const Eigen::Vector2d translation = rotated({velocity_.forward * time_step, velocity_.left * time_step}, 0.5 * turn);
  const Pose2 step(translation, turn);
  pose_ = pose_ * step;
  dead_reckon(step);

  const auto fraction = [](double speed, double limit) { return limit > 0.0 ? std::abs(speed) / limit : 0.0; };
  const double effort = std::clamp(fraction(velocity_.forward, parameters_.forward_limit) +
                                       fraction(velocity_.left, parameters_.left_limit) +
                                       fraction(velocity_.turn, parameters_.turn_limit),
                                   0.0, 1.0);
  effort_ = toward(effort_, effort, 3.0 * time_step);
  gait_ = effort_ > 0.0 ? std::fmod(gait_ + 2.0 * kPi * parameters_.step_frequency * time_step, 2.0 * kPi) : 0.0;
}

void Body::dead_reckon(const Pose2& step) {
  const double distance = step.position.norm();
  const double turn = std::abs(step.rotation);
  if (distance == 0.0 && turn == 0.0) return;
  const double spread = parameters_.odometry_noise * std::sqrt(distance + 0.05 * turn);
  const double spread_turn = parameters_.odometry_noise * std::sqrt(turn + 0.5 * distance);
  const double wrong_turn = spread_turn * random_.normal();
  const double wrong_left = spread * random_.normal();
  const double wrong_forward = spread * random_.normal();
  odometry_ = odometry_ * Pose2(step.position.x() * odometry_scale_.x() + wrong_forward,
                                step.position.y() * odometry_scale_.y() + wrong_left,
                                step.rotation * odometry_scale_.z() + odometry_drift_ * distance + wrong_turn);
}

void Body::balance(double time_step, bool get_up) {
  const double stand = robot_.dimensions.torso_height;
  switch (posture_) {
    case Posture::upright: {
      // The torso rolls once per double step, and pitches and sinks with each step.
      torso_ = {parameters_.sway_roll * effort_ * pinned::sin(gait_),
                parameters_.sway_pitch * effort_ * pinned::sin(2.0 * gait_ + 0.8)};
      torso_height_ = stand - parameters_.sway_height * effort_ * (1.0 + pinned::cos(2.0 * gait_));
      break;
    }
    case Posture::falling: {
      const double fraction = since_ / parameters_.fall_time;
      const double down = std::min(1.0, fraction * fraction);
      torso_ = {down * lying_.roll, down * lying_.pitch};
      torso_height_ = std::lerp(stand, robot_.lying_height, down);
      if (fraction >= 1.0) {
        posture_ = Posture::lying;
        since_ = 0.0;
      }
      break;
    }
    case Posture::lying:
      torso_ = lying_;
      if (get_up && !penalized_ && robot_.get_up_time) stand_up_again();
      break;
    case Posture::getting_up: {
      const double fraction = since_ / parameters_.get_up_time;
      const double up = ease(1.6 * fraction - 0.5);  // arms and legs first
      const double rock = 0.15 * pinned::sin(9.0 * since_) * (1.0 - up) * std::min(1.0, since_);
      torso_ = {(1.0 - up) * lying_.roll + rock, (1.0 - up) * lying_.pitch + 0.5 * rock};
      torso_height_ = std::lerp(robot_.lying_height, stand, up);
      pose_.rotation = normalize_angle(pose_.rotation + slip_ * time_step / parameters_.get_up_time);
      if (fraction >= 1.0) set_down();
      break;
    }
    case Posture::carried: {
      const double t = hands_.pace * since_;
      const double held = hands_.sway * ease(2.0 * since_);  // the operator tilts it gradually
      const double raised = ease(since_ / hands_.raise_time);
      torso_ = {held * (0.12 * pinned::sin(1.9 * t) + 0.04 * pinned::sin(4.3 * t)) + (1.0 - raised) * hands_.tilt.roll,
                held * 0.15 * pinned::sin(1.3 * t + 0.6) + (1.0 - raised) * hands_.tilt.pitch};
      if (hands_.lowered_since < 0.0) {
        torso_height_ = stand + hands_.height * raised - (1.0 - raised) * hands_.below;
        pose_.rotation = normalize_angle(pose_.rotation + 0.25 * pinned::sin(1.1 * t) * time_step);
        break;
      }
      const double fraction = (since_ - hands_.lowered_since) / hands_.lower_time;
      torso_height_ = std::lerp(hands_.held_at, stand, ease(fraction));
      torso_ = {(1.0 - ease(fraction)) * torso_.roll, (1.0 - ease(fraction)) * torso_.pitch};
      if (fraction >= 1.0) set_down();
      break;
    }
  }
}

/// Computes acceleration and angular velocity of the inertial unit in the torso.
void Body::feel(double time_step) {
  const Moment now{{pose_.position.x(), pose_.position.y(), torso_height_}, torso_, pose_.rotation};
  acceleration_.setZero();
  angular_velocity_.setZero();
  if (last_moment_ && time_step > 0.0) {
    const Eigen::Vector3d velocity = (now.torso_origin - last_moment_->torso_origin) / time_step;
    if (last_velocity_) acceleration_ = (velocity - *last_velocity_) / time_step;
    last_velocity_ = velocity;
    angular_velocity_ =
        Eigen::Vector3d(now.torso.roll - last_moment_->torso.roll, now.torso.pitch - last_moment_->torso.pitch,
                        angle_difference(now.heading, last_moment_->heading)) /
        time_step;
  }
  last_moment_ = now;
}

void Body::stand_up_again() {
  posture_ = Posture::getting_up;
  since_ = 0.0;
  slip_ = parameters_.get_up_slip * random_.normal();
}

void Body::collide(std::span<const Barrier> barriers, const Eigen::Vector2d& bounds) {
  for (const Barrier& barrier : barriers) {
    const Clearance clear = clearance(barrier, pose_.position);
    const double deep = kRadius - clear.distance;
    if (deep <= 0.0) continue;
    // The robot slides along the barrier by the rest of the step. The feet continue to walk, so the odometry does, too.
    pose_.position += deep * clear.away;
  }
  pose_.position = pose_.position.cwiseMax(-bounds).cwiseMin(bounds);
}

BodySample Body::sample(double time) {
  const double joint = parameters_.head_noise;
  const double attitude = parameters_.attitude_noise;
  const auto noise = [this](double deviation) {
    const double z = deviation * random_.normal();
    const double y = deviation * random_.normal();
    return Eigen::Vector3d(deviation * random_.normal(), y, z);
  };
  BodySample body;
  body.time = time;
  body.head = {head_.yaw + joint * random_.normal(), head_.pitch + joint * random_.normal()};
  body.torso = {torso_.roll + attitude_bias_.roll + attitude * random_.normal(),
                torso_.pitch + attitude_bias_.pitch + attitude * random_.normal()};
  body.angular_velocity = angular_velocity_ + noise(parameters_.gyroscope_noise);
  const Eigen::Matrix3d field_from_torso =
      rotation_about_z(pose_.rotation) * rotation_about_y(torso_.pitch) * rotation_about_x(torso_.roll);
  const double shock = posture_ == Posture::upright ? parameters_.step_shock * effort_ : 0.0;
  body.acceleration = field_from_torso.transpose() * (acceleration_ + kGravity * Eigen::Vector3d::UnitZ()) +
                      accelerometer_bias_ + noise(pinned::hypot(parameters_.accelerometer_noise, shock));
  const double standing = robot_.standing_load.value_or(0.0);
  const double load = posture_ == Posture::carried ? 0.03 : (posture_ == Posture::upright ? standing : 0.5);
  body.foot_load = std::max(0.0, load + 0.02 * standing * random_.normal());
  if (!parameters_.foot_sensors) body.foot_load = 0.0;
  return body;
}

Isometry3 Body::measured_camera(const RobotDimensions& dimensions, const BodySample& body, HeadCamera camera) const {
  // The legs' kinematics do not contain falls or lifts.
  const double torso_height = posture_ == Posture::upright ? torso_height_ : robot_.dimensions.torso_height;
  return robot_from_camera(dimensions, body.head, body.torso, torso_height, camera);
}

GroundTruth Body::ground_truth() const {
  return {pose_, posture_ == Posture::falling || posture_ == Posture::lying || posture_ == Posture::getting_up,
          posture_ == Posture::carried};
}

Isometry3 Body::field_from_camera(HeadCamera camera) const {
  return to_isometry(pose_) * robot_from_camera(robot_.dimensions, head_, torso_, torso_height_, camera);
}

}  // namespace reorient

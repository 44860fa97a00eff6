// SPDX-License-Identifier: MIT
#include "robots/simulator/simulator.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "geometry/field_landmarks.h"
#include "geometry/pinned_math.h"
#include "robots/simulator/ball/field_exit.h"

namespace reorient {
namespace {

constexpr std::uint64_t kLink = 0x117c;  // random stream of dropped frames

CameraModel camera_of(const SimulatorParameters& parameters, const CameraOptics& optics) {
  const int width = parameters.width / 2 * 2;
  const int height = (width * optics.height / optics.width + 1) / 2 * 2;
  CameraOptics chosen = optics;
  chosen.field_of_view_horizontal = parameters.field_of_view_horizontal;
  chosen.field_of_view_vertical = parameters.field_of_view_vertical;
  chosen.k1 = parameters.distortion_k1;
  chosen.k2 = parameters.distortion_k2;
  CameraModel camera = camera_model(chosen, width, height);
  if (const std::string mistake = mistake_in(camera); !mistake.empty())
    throw std::runtime_error("camera of the simulator: " + mistake);
  return camera;
}

/// The true body, with the errors that the calibration of its cameras does not contain.
RobotBody with_tilt_error(RobotBody body, const SimulatorParameters& parameters, std::uint64_t seed) {
  constexpr std::uint64_t kStream = 0x7117;
  Random random(seed, kStream);
  for (CameraMount* const mount : {&body.dimensions.upper, &body.dimensions.lower})
    mount->tilt += parameters.tilt_offset + parameters.tilt_error * random.normal();
  return body;
}

RobotBody as_built(RobotBody body, const SimulatorParameters& parameters) {
  if (!parameters.body.foot_sensors) body.standing_load.reset();
  if (parameters.cameras == Cameras::both && !body.lower_camera)
    throw std::runtime_error("simulator.cameras: expected upper, because a " + body.name +
                             " has one camera, found both");
  return body;
}

/// Throws if the carpet is larger than the floor.
const Room& checked(const Room& room, const FieldDimensions& field) {
  const Eigen::Vector2d carpet = 2.0 * carpet_half_size(field);
  const Eigen::Vector2d floor = floor_extent(room.shape);
  const bool holds =
      room.shape.form == RoomForm::box ? (carpet.array() <= floor.array()).all() : carpet.norm() <= floor.x();
  if (holds) return room;
  std::ostringstream message;
  message << "room: expected space for a carpet of " << carpet.x() << " x " << carpet.y() << " m, found a "
          << (room.shape.form == RoomForm::box ? "room" : "round room") << " of " << floor.x() << " x " << floor.y()
          << " m; set room_shape.length and room_shape.width with --set";
  throw std::runtime_error(message.str());
}

Eigen::Vector2d bounds_of(const Room& room) {
  constexpr double kFromWall = 0.4;  // m
  const Eigen::Vector2d half = 0.5 * floor_extent(room.shape);
  if (room.shape.form == RoomForm::box) return half - Eigen::Vector2d::Constant(kFromWall);
  // A square inside the round wall.
  return Eigen::Vector2d::Constant((half.x() - kFromWall) * std::sqrt(0.5));
}

/// Posts and nets of both goals.
std::vector<Barrier> barriers_of(const FieldDimensions& field) {
  constexpr double kNet = 0.02;  // m
  std::vector<Barrier> barriers;
  for (const double end : {1.0, -1.0}) {
    const auto [left_post, left_back, right_back, right_post] = goal_outline(field, end);
    barriers.push_back({left_post, left_post, 0.5 * field.goal_post_diameter});
    barriers.push_back({left_post, left_back, kNet});
    barriers.push_back({right_post, right_post, 0.5 * field.goal_post_diameter});
    barriers.push_back({right_post, right_back, kNet});
    barriers.push_back({right_back, left_back, kNet});
  }
  return barriers;
}

Barrier barrier_of(const FurniturePiece& piece) {
  const Eigen::Vector2d half = 0.5 * std::max(piece.length - piece.depth, 0.0) * unit_vector(piece.rotation);
  return {piece.center - half, piece.center + half, 0.5 * piece.depth};
}

/// Angular velocity in the body's own frame, rad/s; zero after a jump, because then the operator moved the robot.
Eigen::Vector3d angular_velocity_of(const Eigen::Matrix3d& before, const Eigen::Matrix3d& now, double time_step) {
  constexpr double kFastest = 20.0;  // rad/s
  const Eigen::Matrix3d turn = before.transpose() * now;
  const Eigen::Vector3d axis(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
  const double sine = 0.5 * axis.norm();
  const double angle = pinned::atan2(sine, 0.5 * (turn.trace() - 1.0));
  if (sine < 1e-9 || angle > kFastest * time_step) return Eigen::Vector3d::Zero();
  return axis * (0.5 * angle / (sine * time_step));
}

RollingBall somewhere_on(const FieldDimensions& field, std::uint64_t seed) {
  constexpr std::uint64_t kStream = 0xba11;
  Random random(seed, kStream);
  RollingBall ball;
  ball.radius = 0.5 * field.ball_diameter;
  ball.position = {random.uniform(-0.35, 0.35) * field.length, random.uniform(-0.35, 0.35) * field.width};
  return ball;
}

}  // namespace

SimulatorParameters simulator_parameters_of(const RobotBody& body) {
  SimulatorParameters parameters;
  parameters.frame_rate = body.upper_camera.rate;
  parameters.field_of_view_horizontal = body.upper_camera.field_of_view_horizontal;
  parameters.field_of_view_vertical = body.upper_camera.field_of_view_vertical;
  parameters.distortion_k1 = body.upper_camera.k1;
  parameters.distortion_k2 = body.upper_camera.k2;
  parameters.body = body_parameters_of(body);
  return parameters;
}

Simulator::Simulator(const SimulatorParameters& parameters, const RobotBody& body, const FieldDimensions& field,
                     const Room& room, const Pose2& start, std::uint64_t seed)
    : parameters_(parameters),
      field_(field),
      room_(checked(room, field)),
      bounds_(bounds_of(room)),
      fixed_barriers_(barriers_of(field)),
      robot_(as_built(body, parameters)),
      size_(standing_camera_height(robot_) / standing_camera_height(RobotBody())),
      camera_(camera_of(parameters, robot_.upper_camera)),
      body_(parameters.body, with_tilt_error(robot_, parameters, seed), start, seed),
      players_(parameters.other_robots, field, start.position, seed),
      ball_(somewhere_on(field, seed)),
      ball_sensor_(parameters.ball_sensor, seed),
      kick_(parameters.kick, seed),
      spectators_(parameters.spectators, room.shape, field, room.light, parameters.surroundings_seed.value_or(seed)),
      light_(parameters.light, room.shape.height, parameters.surroundings_seed.value_or(seed)),
      link_(seed, kLink),
      upper_(camera_, field, room, parameters.labels, parameters, seed) {
  constexpr std::uint64_t kLowerNoise = 0x10e6;
  if (parameters.cameras == Cameras::both) lower_.emplace(camera_, field, room, false, parameters, seed ^ kLowerNoise);
  add_goals(scene_, field_, room_.light);
  for (const FurniturePiece& piece : furnish(parameters.furniture, room.shape, field)) {
    add_furniture(scene_, piece, wall_perimeter(room.shape));
    fixed_barriers_.push_back(barrier_of(piece));
  }
  standing_capsules_ = scene_.capsules.size();
  standing_shadows_ = scene_.shadows.size();
}

bool Simulator::observe(Observation& observation) {
  if (!is_in_game_) {
    body_samples_.clear();
    move_world();
    while (is_dropped()) {
      ++frame_;
      move_world();
    }
  }
  look(observation);
  if (application_) report_ball(observation.external);
  ++frame_;
  return true;
}

bool Simulator::is_dropped() {
  return parameters_.dropped_frames > 0.0 && frame_ > 0 && link_.uniform() < parameters_.dropped_frames;
}

void Simulator::answer(const Answer& answer) {
  if (application_) application_->begin(answer.actions, kick_);
  if (parameters_.latency <= 0.0) {
    request_ = answer.request;
    return;
  }
  const auto frames = static_cast<std::uint64_t>(std::ceil(parameters_.latency * parameters_.frame_rate));
  waiting_.push_back({frame_ + frames, answer.request});
}

void Simulator::take_requests() {
  const auto due =
      std::find_if(waiting_.begin(), waiting_.end(), [this](const Waiting& one) { return one.from > frame_; });
  if (due == waiting_.begin()) return;
  request_ = std::prev(due)->request;
  waiting_.erase(waiting_.begin(), due);
}

void Simulator::move_world() {
  const double time_step = 1.0 / parameters_.frame_rate;
  players_.advance(time_step, body_.pose().position, fixed_barriers_);
  move_body();
  if (parameters_.ball) roll_ball();
}

void Simulator::advance() {
  body_samples_.clear();
  move_body();
  kick();
}

void Simulator::share(const SharedWorld& world) {
  is_in_game_ = true;
  players_.place(world.others);
  ball_ = world.ball;
}

void Simulator::move_body() {
  const double time_step = 1.0 / parameters_.frame_rate;
  barriers_.assign(fixed_barriers_.begin(), fixed_barriers_.end());
  for (const Player& player : players_.all()) {
    barriers_.push_back({player.pose.position, player.pose.position, Players::kRadius});
  }
  take_requests();
  Request request = request_;
  if (kick_.is_active()) request.walk = {};
  const int samples = std::max(1, parameters_.body_samples);
  const double now = static_cast<double>(frame_) * time_step;
  for (int i = 1; i <= samples; ++i) {
    body_.advance(time_step / samples, request, barriers_, bounds_);
    body_samples_.push_back(body_.sample(now - time_step * (samples - i) / samples));
    // The two cameras of a robot are not synchronized: the lower one is exposed shortly before the upper one.
    if (lower_ && (i == samples - 1 || samples == 1)) {
      lower_frame_ = moment(HeadCamera::lower, body_samples_.back());
      field_from_lower_ = body_.field_from_camera(HeadCamera::lower);
    }
  }
}

void Simulator::kick() {
  kicked_.reset();
  if (!application_ || !kick_.is_active()) return;
  const WalkVelocity& walk = body_.velocity();
  const KickerState kicker{.pose = body_.pose(),
                           .is_upright = body_.posture() == Body::Posture::upright,
                           .is_lifted = body_.posture() == Body::Posture::carried,
                           .is_penalized = body_.is_penalized(),
                           .speed = pinned::hypot(walk.forward, walk.left),
                           .size = size_};
  const std::optional<Eigen::Vector2d> ball = parameters_.ball ? std::optional(ball_.position) : std::nullopt;
  const Kick::Progress progress =
      kick_.advance(1.0 / parameters_.frame_rate, kicker, ball, ball_mass(field_.ball_diameter));
  application_->take(progress);
  kicked_ = progress.velocity;
}

void Simulator::roll_ball() {
  kick();
  if (kicked_) ball_.velocity = *kicked_;
  if (body_.posture() == Body::Posture::upright)
    ball_.touch(body_.pose().position, Body::kRadius, parameters_.ball_physics);
  for (const Player& player : players_.all())
    ball_.touch(player.pose.position, Body::kRadius, parameters_.ball_physics);
  ball_.advance(1.0 / parameters_.frame_rate, parameters_.ball_physics, fixed_barriers_, carpet_half_size(field_));
  count_goals();
}

void Simulator::count_goals() {
  const std::optional<FieldExit> exit = exit_of(ball_, field_);
  const bool was_in_goal = std::exchange(is_in_goal_, exit && exit->line == FieldExit::Line::goal);
  if (is_in_goal_ && !was_in_goal) ++goals_[exit->side > 0.0 ? 0 : 1];
}

void Simulator::put_ball(const Eigen::Vector2d& where) {
  ball_.position = where;
  ball_.velocity.setZero();
  is_in_goal_ = false;
}

std::optional<BallTruth> Simulator::true_ball() const {
  if (!parameters_.ball) return std::nullopt;
  return BallTruth{ball_.position, goals_[0], goals_[1]};
}

void Simulator::report_ball(ExternalInputs& external) {
  application_->report_kick(external);
  occluders_.clear();
  for (const Player& player : players_.all()) {
    constexpr double kLying = 0.15;  // m, height of a lying NAO
    const Occluder standing;
    occluders_.push_back(
        {player.pose.position, size_ * standing.radius, size_ * (player.is_lying ? kLying : standing.height)});
  }
  const Eigen::Vector3d center(ball_.position.x(), ball_.position.y(), ball_.radius);
  // The detector uses both cameras of the body, also if the robot sends the images of one.
  const std::array<Isometry3, 2> cameras{field_from_camera_, body_.field_from_camera(HeadCamera::lower)};
  const std::size_t count = robot_.lower_camera ? 2 : 1;
  const std::optional<Eigen::Vector2d> measured =
      ball_sensor_.measure({center, body_.pose(), std::span(cameras).first(count), camera_, occluders_});
  const bool can_see = parameters_.ball && body_.posture() == Body::Posture::upright;
  application_->report_ball(can_see ? measured : std::nullopt, external);
}

CameraFrame Simulator::moment(HeadCamera camera, const BodySample& body) const {
  CameraFrame frame;
  frame.time = body.time;
  frame.camera = camera_;
  frame.odometry = body_.odometry();
  frame.robot_from_camera = body_.measured_camera(robot_.dimensions, body, camera);
  return frame;
}

void Simulator::expose(Eye& eye, CameraFrame& frame) {
  const double time_step = 1.0 / parameters_.frame_rate;
  const Isometry3& pose = &eye == &upper_ ? field_from_camera_ : field_from_lower_;
  const Eigen::Matrix3d rotation = pose.linear();
  const Eigen::Vector3d angular_velocity = eye.field_from_camera
                                               ? angular_velocity_of(*eye.field_from_camera, rotation, time_step)
                                               : Eigen::Vector3d::Zero();
  eye.field_from_camera = rotation;
  const Frame& drawn = eye.renderer.render(pose, scene_, angular_velocity, parameters_.sensor.readout_time);
  eye.sensor.expose(drawn, frame_, time_step, eye.image, angular_velocity);
  frame.image = eye.image.view();
}

void Simulator::look(Observation& observation) {
  observation = {};
  observation.time = static_cast<double>(frame_) / parameters_.frame_rate;
  light_up();
  place_people(observation.time);
  observation.body = body_samples_.back();
  observation.body_samples = body_samples_;
  observation.odometry = body_.odometry();

  field_from_camera_ = body_.field_from_camera();
  if (lower_) {
    expose(*lower_, *lower_frame_);
    pairing_.put_lower(*lower_frame_, observation.time);
  }
  CameraFrame upper = moment(HeadCamera::upper, observation.body);
  upper.time = observation.time;
  expose(upper_, upper);
  pairing_.put_upper(upper);
  pairing_.take(observation);
}

void Simulator::place_people(double time) {
  scene_.capsules.resize(standing_capsules_);
  scene_.shadows.resize(standing_shadows_);
  static const LinearColor kJerseys[] = {{0.03f, 0.07f, 0.42f}, {0.55f, 0.02f, 0.03f}};
  for (const Player& player : players_.all()) {
    add_robot(scene_, player.pose, player.stride, size_, kJerseys[player.team], room_.light, player.is_lying);
  }
  if (parameters_.ball) add_ball(scene_, ball_.position, field_.ball_diameter, room_.light);
  spectators_.add_to(scene_, time);
}

void Simulator::light_up() {
  if (!light_.changed()) return;
  const double time_step = 1.0 / parameters_.frame_rate;
  light_.advance(time_step);
  scene_.illumination = light_.illumination();
  scene_.illumination.repeated = room_.shape.symmetry != RoomSymmetry::none;
  upper_.sensor.set_gains(light_.gains());
  if (lower_) lower_->sensor.set_gains(light_.gains());
  constexpr double kMinute = 60.0;  // s
  spectators_.exchange(parameters_.light.people_turnover * time_step / kMinute);
}

void Simulator::change_light() {
  light_.change();
  scene_.patches = light_.draw_patches(room_);
  spectators_.exchange(parameters_.light.people_exchanged);
}

void Simulator::set_exposure_compensation(double stops) {
  upper_.sensor.set_stops(stops);
  if (lower_) lower_->sensor.set_stops(stops);
}

std::span<const Label> Simulator::labels() const { return upper_.renderer.frame().labels; }

std::span<const float> Simulator::depth() const {
  if (!parameters_.labels) return {};
  return upper_.renderer.frame().depth;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "robots/nao/body_history.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"

namespace reorient::nao {
namespace {

BodySample sample_of(const Measurement& measurement) {
  BodySample body;
  body.time = measurement.time;
  body.head = {measurement.position[kHeadYaw], measurement.position[kHeadPitch]};
  body.torso = {measurement.angles[0], measurement.angles[1]};
  // Positive: rolling to the right, pitching forward, turning to the left; about x, y and z.
  body.angular_velocity = {measurement.gyroscope[0], measurement.gyroscope[1], measurement.gyroscope[2]};
  // Relative to free fall it is +9.81 upwards; LoLA sends the opposite sign.
  body.acceleration = {-measurement.accelerometer[0], -measurement.accelerometer[1], -measurement.accelerometer[2]};
  body.foot_load = std::accumulate(measurement.fsr.begin(), measurement.fsr.end(), 0.0);
  return body;
}

double between(double from, double to, double fraction) { return from + fraction * (to - from); }

}  // namespace

void BodyHistory::add(const Measurement& measurement) {
  const BodySample body = sample_of(measurement);
  if (count_ > 0) {
    const double step = body.time - from_end(0).body.time;
    if (step <= 0.0) return;
    if (step < kGap) turn(body, step);
  }
  walk(measurement);
  moments_[count_ % kKept] = {body, Pose2(position_, yaw_)};
  ++count_;
}

/// Integrates the angular velocity about the vertical, minus the gyroscope's bias, which is learned while the robot
/// stands still.
void BodyHistory::turn(const BodySample& body, double step) {
  const double pitch = body.torso.pitch, roll = body.torso.roll;
  const Eigen::Vector3d up(-pinned::sin(pitch), pinned::cos(pitch) * pinned::sin(roll),
                           pinned::cos(pitch) * pinned::cos(roll));
  const double rate = up.dot(body.angular_velocity);
  constexpr double kStill = 0.05;     // rad/s about any axis
  constexpr double kStillTime = 1.0;  // s
  constexpr double kBiasTime = 5.0;   // s
  constexpr double kLoaded = 1.0;     // kg, above which the robot stands on its own feet
  const bool is_still = body.angular_velocity.norm() < kStill && body.foot_load > kLoaded;
  still_for_ = is_still ? still_for_ + step : 0.0;
  if (still_for_ > kStillTime) bias_ += step / kBiasTime * (rate - bias_);
  yaw_ += step * (rate - bias_);
}

/// Adds the translation since the last cycle, rotated by the inertial unit's heading. If it is longer than any real
/// step, the walk has restarted its odometry, and the translation is ignored.
void BodyHistory::walk(const Measurement& measurement) {
  const auto& [forward, left, turned] = measurement.walked;
  if (measurement.is_walked == 0 || !std::isfinite(forward) || !std::isfinite(left) || !std::isfinite(turned)) {
    walked_.reset();
    return;
  }
  const Pose2 now(forward, left, turned);
  constexpr double kLongestStep = 0.1;  // m in one cycle, or in a few if some are missing
  if (walked_) {
    const Eigen::Vector2d step = (walked_->inverse() * now).position;
    if (step.norm() <= kLongestStep) position_ += rotated(step, normalize_angle(yaw_));
  }
  walked_ = now;
}

std::optional<BodyHistory::Moment> BodyHistory::newest() const {
  return count_ > 0 ? std::optional(from_end(0)) : std::nullopt;
}

std::optional<BodyHistory::Moment> BodyHistory::at(double time) const {
  const std::size_t kept = std::min(count_, kKept);
  if (kept == 0 || time > from_end(0).body.time + kGap) return std::nullopt;
  if (time >= from_end(0).body.time) return from_end(0);
  for (std::size_t back = 1; back < kept; ++back) {
    const Moment &before = from_end(back), &after = from_end(back - 1);
    if (before.body.time > time) continue;
    const double gap = after.body.time - before.body.time;
    if (gap > kGap) return std::nullopt;
    const double fraction = (time - before.body.time) / gap;
    Moment moment = fraction < 0.5 ? before : after;
    moment.body.time = time;
    moment.body.head = {between(before.body.head.yaw, after.body.head.yaw, fraction),
                        between(before.body.head.pitch, after.body.head.pitch, fraction)};
    moment.body.torso = {between(before.body.torso.roll, after.body.torso.roll, fraction),
                         between(before.body.torso.pitch, after.body.torso.pitch, fraction)};
    moment.odometry.position =
        before.odometry.position + fraction * (after.odometry.position - before.odometry.position);
    const double turned = angle_difference(after.odometry.rotation, before.odometry.rotation);
    moment.odometry.rotation = normalize_angle(before.odometry.rotation + fraction * turned);
    return moment;
  }
  return std::nullopt;
}

}  // namespace reorient::nao

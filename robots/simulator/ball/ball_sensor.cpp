// SPDX-License-Identifier: MIT
#include "robots/simulator/ball/ball_sensor.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"

namespace reorient {
namespace {

/// Whether the line of sight from `eye` to `target` passes through the occluder.
bool hides(const Occluder& occluder, const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
  const Eigen::Vector2d line = (target - eye).head<2>();
  const double length2 = line.squaredNorm();
  if (length2 <= 0.0) return false;
  const double fraction = (occluder.position - eye.head<2>()).dot(line) / length2;
  if (fraction <= 0.0 || fraction >= 1.0) return false;
  const Eigen::Vector3d nearest = eye + fraction * (target - eye);
  return (nearest.head<2>() - occluder.position).norm() < occluder.radius && nearest.z() < occluder.height;
}

}  // namespace

bool is_in_view(const BallView& view, const Isometry3& field_from_camera) {
  const Eigen::Vector3d in_camera = field_from_camera.inverse() * view.ball;
  const std::optional<Eigen::Vector2d> pixel = view.camera.project(in_camera);
  if (!pixel || !view.camera.contains(*pixel)) return false;
  const Eigen::Vector3d eye = field_from_camera.translation();
  return std::none_of(view.occluders.begin(), view.occluders.end(),
                      [&](const Occluder& occluder) { return hides(occluder, eye, view.ball); });
}

std::optional<Eigen::Vector2d> BallSensor::measure(const BallView& view) {
  const double bearing_error = parameters_.bearing_noise * random_.normal();
  const double elevation_error = parameters_.elevation_noise * random_.normal();
  const bool is_missed = random_.uniform() < parameters_.missed;

  const auto seeing = std::find_if(view.field_from_cameras.begin(), view.field_from_cameras.end(),
                                   [&](const Isometry3& pose) { return is_in_view(view, pose); });
  if (is_missed || seeing == view.field_from_cameras.end()) return std::nullopt;
  const Eigen::Vector3d eye = seeing->translation();
  const double height = eye.z() - view.ball.z();
  const double distance = (view.ball - eye).head<2>().norm();
  if (height <= 0.0 || distance > parameters_.range) return std::nullopt;

  // Near the horizon the distance would become infinite, so the result ends a little beyond the range.
  constexpr double kBeyondRange = 1.5;
  const double depression = pinned::atan2(height, distance) + elevation_error;
  const auto [sine, cosine] = pinned::sincos(depression);
  const double farthest = kBeyondRange * parameters_.range;
  const double measured = sine * farthest > height * cosine ? std::max(0.0, height * cosine / sine) : farthest;

  const Eigen::Vector2d eye_in_robot = rotated(eye.head<2>() - view.robot.position, -view.robot.rotation);
  const Eigen::Vector2d ball_in_robot =
      rotated(view.ball.head<2>() - view.robot.position, -view.robot.rotation) - eye_in_robot;
  const double bearing = direction_of(ball_in_robot) + bearing_error;
  return eye_in_robot + measured * unit_vector(bearing);
}

}  // namespace reorient

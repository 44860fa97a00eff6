// Where a point on the ground is seen if the camera's attitude is a little other than it was taken for.
#pragma once

#include <algorithm>

#include "geometry/camera_bias.h"
#include "geometry/transform.h"

namespace reorient {

/// A camera that is lower than this (m) says nothing about places on the ground.
inline constexpr double kLeastCameraHeight = 0.1;

/// How a point on the ground moves (m/rad) as the camera is rotated about the robot's axes through the camera.
struct TiltDerivative {
  Eigen::Vector2d by_roll;
  Eigen::Vector2d by_pitch;
};
inline TiltDerivative tilt_derivative(const Eigen::Vector2d& point, const Isometry3& robot_from_camera) {
  const Eigen::Vector2d away = point - robot_from_camera.translation().head<2>();
  const double height = std::max(robot_from_camera.translation().z(), kLeastCameraHeight);
  return {Eigen::Vector2d(0.0, height) + away * (away.y() / height),
          Eigen::Vector2d(-height, 0.0) - away * (away.x() / height)};
}

/// The point itself after such a rotation: the same ray, exact for small angles however far away it is. Where it does
/// not meet the ground any more, a point far away.
inline Eigen::Vector2d moved_by_tilt(const Eigen::Vector2d& point, const Isometry3& robot_from_camera,
                                     const TiltBias& turn) {
  constexpr double kFarthest = 20.0;  // times as far
  const Eigen::Vector2d origin = robot_from_camera.translation().head<2>();
  const Eigen::Vector2d away = point - origin;
  const double height = std::max(robot_from_camera.translation().z(), kLeastCameraHeight);
  const double descent = height - (turn.roll * away.y() - turn.pitch * away.x());
  const double longer = descent * kFarthest > height ? height / descent : kFarthest;
  return origin + longer * (away + Eigen::Vector2d(-height * turn.pitch, height * turn.roll));
}

/// How the sum of the biases (bias_of()) changes with the roll and the pitch of a camera's mounting: the camera's
/// horizontal direction, of length 1; zero where it looks straight down.
inline Eigen::Vector2d mount_axis(const Isometry3& robot_from_camera) {
  const Eigen::Vector2d ahead = robot_from_camera.linear().col(0).head<2>();
  const double length = ahead.norm();
  return length > 0.0 ? Eigen::Vector2d(ahead / length) : Eigen::Vector2d::Zero();
}

}  // namespace reorient

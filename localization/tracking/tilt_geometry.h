// SPDX-License-Identifier: MIT
// Where a point on the ground is seen if the camera's attitude is a little other than it was taken for.
#pragma once

#include <algorithm>
#include <cmath>

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

/// How the distance of a point from a line changes with each bias, m/rad.
struct TiltRow {
  double roll = 0.0;  ///< of the torso
  double pitch = 0.0;
  double mount_roll = 0.0;  ///< of the camera's mounting
  double mount_pitch = 0.0;
};
/// `normal`: across the line, of length 1, robot frame. `axis`: mount_axis() of the camera.
inline TiltRow tilt_row(const Eigen::Vector2d& normal, const Eigen::Vector2d& point, const Isometry3& robot_from_camera,
                        const Eigen::Vector2d& axis) {
  const TiltDerivative derivative = tilt_derivative(point, robot_from_camera);
  const double roll = normal.dot(derivative.by_roll), pitch = normal.dot(derivative.by_pitch);
  return {roll, pitch, axis.x() * roll + axis.y() * pitch, axis.x() * pitch - axis.y() * roll};
}

/// How far a point on the ground moves across a line if the direction in which it is seen changes, at most: along the
/// line of sight with the square of its distance, across it with the distance itself.
inline double metres_per_radian(const Eigen::Vector2d& point, const Eigen::Vector2d& normal,
                                const Isometry3& robot_from_camera) {
  const double distance = point.norm();
  const double height = std::max(robot_from_camera.translation().z(), kLeastCameraHeight);
  const double along = std::abs(normal.dot(point)) / distance;
  return along * (height + distance * distance / height) + (1.0 - along) * distance;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
// How the measured position of a point on the ground changes with small errors of the camera's attitude.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/camera_bias.h"
#include "geometry/transform.h"

namespace reorient {

/// A camera lower than this (m) cannot measure positions on the ground.
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

/// The point after such a rotation: the same ray, exact for small angles at any distance. A point far away if the ray
/// does not meet the ground any more.
inline Eigen::Vector2d moved_by_tilt(const Eigen::Vector2d& point, const Isometry3& robot_from_camera,
                                     const TiltBias& turn) {
  constexpr double kFarthest = 20.0;  // times the former distance
  const Eigen::Vector2d origin = robot_from_camera.translation().head<2>();
  const Eigen::Vector2d away = point - origin;
  const double height = std::max(robot_from_camera.translation().z(), kLeastCameraHeight);
  const double descent = height - (turn.roll * away.y() - turn.pitch * away.x());
  const double longer = descent * kFarthest > height ? height / descent : kFarthest;
  return origin + longer * (away + Eigen::Vector2d(-height * turn.pitch, height * turn.roll));
}

/// Derivative of a point's distance from a line by each bias, m/rad.
struct TiltRow {
  double roll = 0.0;  ///< of the torso
  double pitch = 0.0;
  double mount_roll = 0.0;  ///< of the camera's mounting
  double mount_pitch = 0.0;
};
/// `normal`: unit vector across the line, robot frame. `axis`: mount_axis() of the camera.
inline TiltRow tilt_row(const Eigen::Vector2d& normal, const Eigen::Vector2d& point, const Isometry3& robot_from_camera,
                        const Eigen::Vector2d& axis) {
  const TiltDerivative derivative = tilt_derivative(point, robot_from_camera);
  const double roll = normal.dot(derivative.by_roll), pitch = normal.dot(derivative.by_pitch);
  return {roll, pitch, axis.x() * roll + axis.y() * pitch, axis.x() * pitch - axis.y() * roll};
}

/// Upper bound of how far a point on the ground moves across a line if the direction of its line of sight changes.
/// Along the line of sight it grows with the square of the distance, across it linearly.
inline double meters_per_radian(const Eigen::Vector2d& point, const Eigen::Vector2d& normal,
                                const Isometry3& robot_from_camera) {
  const double distance = point.norm();
  const double height = std::max(robot_from_camera.translation().z(), kLeastCameraHeight);
  const double along = std::abs(normal.dot(point)) / distance;
  return along * (height + distance * distance / height) + (1.0 - along) * distance;
}

}  // namespace reorient

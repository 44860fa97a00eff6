// SPDX-License-Identifier: MIT
// Poses on the ground: meters, radians; x forward, y left; the field's origin is its center.
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "geometry/angle.h"
#include "geometry/const_or.h"
#include "geometry/transform.h"

namespace reorient {

/// A rigid motion of the plane. As a transform, `field_from_robot * point_in_robot = point_in_field`.
struct Pose2 {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< m
  double rotation = 0.0;                               ///< rad, in (-pi, pi]

  Pose2() = default;
  Pose2(double x, double y, double angle) : position(x, y), rotation(normalize_angle(angle)) {}
  Pose2(const Eigen::Vector2d& where, double angle) : position(where), rotation(normalize_angle(angle)) {}

  Eigen::Vector2d operator*(const Eigen::Vector2d& point) const { return position + rotated(point, rotation); }
  Pose2 operator*(const Pose2& next) const { return {*this * next.position, rotation + next.rotation}; }
  Pose2 inverse() const { return {rotated(-position, -rotation), -rotation}; }
};

template <typename Visit, ConstOr<Pose2> T>
void fields(Visit&& visit, T& pose) {
  visit(pose.position, pose.rotation);
}

/// The pose that looks the same on a field that is symmetric about its center: (x, y, a) -> (-x, -y, a + pi).
inline Pose2 reflect(const Pose2& pose) { return {-pose.position, pose.rotation + kPi}; }

/// Whether the poses differ by less than `meters` and less than `radians`. False for numbers that are not finite.
inline bool are_near(const Pose2& one, const Pose2& other, double meters, double radians) {
  return (one.position - other.position).norm() < meters &&
         std::abs(angle_difference(one.rotation, other.rotation)) < radians;
}

/// The pose as a rigid motion of space that does not change heights.
inline Isometry3 to_isometry(const Pose2& pose) {
  Isometry3 result = Isometry3::Identity();
  result.translation().head<2>() = pose.position;
  result.linear() = rotation_about_z(pose.rotation);
  return result;
}

}  // namespace reorient

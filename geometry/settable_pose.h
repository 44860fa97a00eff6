// SPDX-License-Identifier: MIT
// Poses that may be set from outside, for example by an operator, a script or a client.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

#include "geometry/pose2.h"

namespace reorient {

/// Largest distance of a robot from the field's center along each axis, m: beyond the largest field with its border.
inline constexpr double kFarthestPose = 100.0;

/// The error of a pose (m, m, rad) that is set from outside: what was expected and found. Empty for a valid pose.
/// Numbers that are not finite are errors, too.
inline std::string mistake_in_pose(double x, double y, double rotation) {
  constexpr double kMostTurned = 200.0 * kPi;  // rad
  if (std::abs(x) <= kFarthestPose && std::abs(y) <= kFarthestPose && std::abs(rotation) <= kMostTurned) return "";
  const auto text = [](double value) {
    char digits[32];
    std::snprintf(digits, sizeof(digits), "%g", value);
    return std::string(digits);
  };
  return "expected a pose within " + text(kFarthestPose) + " m of the field's center along each axis and within 100 " +
         "turns, found " + text(x) + " m, " + text(y) + " m, " + text(rotation) + " rad";
}

inline std::string mistake_in_pose(const Pose2& pose) {
  return mistake_in_pose(pose.position.x(), pose.position.y(), pose.rotation);
}

}  // namespace reorient

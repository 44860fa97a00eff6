// SPDX-License-Identifier: MIT
// Difference between the mounting of a robot's camera and the recorded mounting or the data sheet.
#pragma once

#include "geometry/transform.h"

namespace reorient {

struct CameraOffset {
  double tilt = 0.0;    ///< rad, down
  double pan = 0.0;     ///< rad, to the left
  double roll = 0.0;    ///< rad, left side up
  double height = 0.0;  ///< m, up
};

/// The camera's pose, rotated about its own axes (first to the left, then down, then about the line of sight) and
/// raised by the height.
inline Isometry3 turned(const Isometry3& robot_from_camera, const CameraOffset& offset) {
  Isometry3 result = robot_from_camera;
  result.linear() = robot_from_camera.linear() * rotation_about_z(offset.pan) * rotation_about_y(offset.tilt);
  // A roll of 0 must not change the bits of the result, so it is skipped.
  if (offset.roll != 0.0) result.linear() = result.linear() * rotation_about_x(offset.roll);
  result.translation().z() += offset.height;
  return result;
}

}  // namespace reorient

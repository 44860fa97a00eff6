// By how much one robot's camera looks elsewhere than the data sheet of its kind says.
#pragma once

#include "geometry/transform.h"

namespace reorient {

struct CameraOffset {
  double tilt = 0.0;  ///< rad, downwards
  double pan = 0.0;   ///< rad, to the left
};

/// The camera's pose, turned about its own axes: first to the left, then down.
inline Isometry3 turned(const Isometry3& robot_from_camera, const CameraOffset& offset) {
  Isometry3 result = robot_from_camera;
  result.linear() = robot_from_camera.linear() * rotation_about_z(offset.pan) * rotation_about_y(offset.tilt);
  return result;
}

}  // namespace reorient

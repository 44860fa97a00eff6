// SPDX-License-Identifier: MIT
#include "geometry/camera_attitude.h"

#include "geometry/pinned_math.h"

namespace reorient {

double pitch_of(const Isometry3& robot_from_camera) {
  const Eigen::Matrix3d& axes = robot_from_camera.linear();
  return pinned::atan2(-axes(2, 0), pinned::hypot(axes(2, 1), axes(2, 2)));
}

double roll_of(const Isometry3& robot_from_camera) {
  const Eigen::Matrix3d& axes = robot_from_camera.linear();
  return pinned::atan2(axes(2, 1), axes(2, 2));
}

Isometry3 with_pitch(const Isometry3& robot_from_camera, double pitch) {
  return with_attitude(robot_from_camera, pitch, roll_of(robot_from_camera));
}

Isometry3 with_attitude(const Isometry3& robot_from_camera, double pitch, double roll) {
  const Eigen::Matrix3d& axes = robot_from_camera.linear();
  Isometry3 result = robot_from_camera;
  result.linear() =
      rotation_about_z(pinned::atan2(axes(1, 0), axes(0, 0))) * rotation_about_y(pitch) * rotation_about_x(roll);
  return result;
}

Isometry3 with_recorded(const Isometry3& robot_from_camera, const RecordedAttitude& recorded) {
  if (recorded == RecordedAttitude()) return robot_from_camera;
  return with_attitude(robot_from_camera, recorded.pitch ? pitch_of(robot_from_camera) : 0.0,
                       recorded.roll ? roll_of(robot_from_camera) : 0.0);
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Pitch and roll of a camera relative to the ground.
#pragma once

#include "geometry/transform.h"

namespace reorient {

/// The pitch of a camera, rad down.
double pitch_of(const Isometry3& robot_from_camera);
/// The roll of a camera, rad, left side up.
double roll_of(const Isometry3& robot_from_camera);
/// The same camera with another pitch. Position, roll and yaw are unchanged.
Isometry3 with_pitch(const Isometry3& robot_from_camera, double pitch);
/// The same camera with another pitch and roll.
Isometry3 with_attitude(const Isometry3& robot_from_camera, double pitch, double roll);

/// Which parts of the attitude that was recorded with an image belong to that image. A sensor or an image can be late.
struct RecordedAttitude {
  bool pitch = true, roll = true;
  bool operator==(const RecordedAttitude&) const = default;
};
/// The attitude with 0 for the parts that do not belong to the image. If all belong to it, the bits are unchanged.
Isometry3 with_recorded(const Isometry3& robot_from_camera, const RecordedAttitude& recorded);

}  // namespace reorient

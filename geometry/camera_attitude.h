// SPDX-License-Identifier: MIT
// How far down a camera looks and how it is rolled, against the ground.
#pragma once

#include "geometry/transform.h"

namespace reorient {

/// The pitch of a camera, rad downwards.
double pitch_of(const Isometry3& robot_from_camera);
/// The roll of a camera, rad, left side up.
double roll_of(const Isometry3& robot_from_camera);
/// The same camera with another pitch. Position, roll and yaw stay.
Isometry3 with_pitch(const Isometry3& robot_from_camera, double pitch);
/// With another pitch and roll.
Isometry3 with_attitude(const Isometry3& robot_from_camera, double pitch, double roll);

/// What of the attitude that was recorded with each image belongs to the image. A sensor can be late, or an image.
struct RecordedAttitude {
  bool pitch = true, roll = true;
  bool operator==(const RecordedAttitude&) const = default;
};
/// With 0 for what does not belong to the image. All of it: the same bits.
Isometry3 with_recorded(const Isometry3& robot_from_camera, const RecordedAttitude& recorded);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Estimates the pitch and roll of a camera from the field lines in one of its images; its height above the ground is
// known.
#pragma once

#include "geometry/camera.h"
#include "geometry/field_dimensions.h"
#include "geometry/image.h"
#include "geometry/transform.h"
#include "perception/field/field_feature_parameters.h"

namespace reorient {

struct PitchEstimate {
  bool known = false;      ///< false: the image does not show it
  double pitch = 0.0;      ///< rad, downward; the most likely one
  double roll = 0.0;       ///< rad, left side up; the most likely one with it
  double deviation = 0.0;  ///< rad, of the pitches that are likely
  double certainty = 0.0;  ///< probability that the pitch is within 2 degrees of `pitch`, in [0, 1]
  int stripes = 0;         ///< points on bright stripes on the carpet, of any width
  int fitting = 0;         ///< those of them that are as wide as a field line at their distance
};

/// Tries pitches from -20 to 45 degrees, all equally likely a priori. A pitch is likely if many stripes have the
/// width of a field line at the distance that it implies, if they run in two perpendicular directions on the
/// ground, and if all carpet is below the horizon. If the roll is unknown, rolls of up to 8 degrees are tried with each
/// pitch; small ones are more likely a priori. `robot_from_camera`: its pitch is not used.
PitchEstimate search_pitch(const ImageView& image, const CameraModel& camera, const Isometry3& robot_from_camera,
                           bool roll_is_known, const FieldFeatureParameters& parameters, const FieldDimensions& field);

}  // namespace reorient

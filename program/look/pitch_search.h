// SPDX-License-Identifier: MIT
// How far down a camera looked, and how it was rolled, from the field lines in one of its images: the height above the
// ground is known.
#pragma once

#include "geometry/camera.h"
#include "geometry/field_dimensions.h"
#include "geometry/image.h"
#include "geometry/transform.h"
#include "perception/field/field_feature_parameters.h"

namespace reorient {

struct PitchEstimate {
  bool known = false;      ///< false: the image does not show it
  double pitch = 0.0;      ///< rad, downwards; the most likely one
  double roll = 0.0;       ///< rad, left side up; the most likely one with it
  double deviation = 0.0;  ///< rad, of the pitches that are likely
  double certainty = 0.0;  ///< probability that the pitch is within 2 degrees of `pitch`, in [0, 1]
  int stripes = 0;         ///< places on bright stripes on the carpet, whatever their width
  int fitting = 0;         ///< those of them that are as wide as a field line at their distance
};

/// Tries pitches from -20 to 45 degrees, all equally likely beforehand. A pitch is likely where many stripes have the
/// width of a field line at the distance that it implies, where they run in two directions at right angles on the
/// ground, and where all carpet is below the horizon. Where the roll is not known, rolls of up to 8 degrees are tried
/// with each pitch; small ones are more likely beforehand. `robot_from_camera`: its pitch is not used.
PitchEstimate search_pitch(const ImageView& image, const CameraModel& camera, const Isometry3& robot_from_camera,
                           bool roll_is_known, const FieldFeatureParameters& parameters, const FieldDimensions& field);

}  // namespace reorient

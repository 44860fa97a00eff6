// SPDX-License-Identifier: MIT
// What the field vision sees in an image that has none before it.
#pragma once

#include "perception/field/field_features.h"

namespace reorient {

/// No other image will come: what covers the near ground is the carpet.
FieldFeatureParameters for_still_image(FieldFeatureParameters parameters);

/// Looks several times, as a robot that stands: what is known of the carpet and of white comes from the looks before.
FieldPercept percept_of_still_image(const ImageView& image, const CameraModel& camera,
                                    const Isometry3& robot_from_camera, const FieldFeatureParameters& parameters,
                                    const FieldDimensions& field);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// The percepts of the field vision in a single image.
#pragma once

#include "perception/field/field_features.h"

namespace reorient {

/// Assumes that the near ground is the carpet, because no other image follows.
FieldFeatureParameters for_still_image(FieldFeatureParameters parameters);

/// Processes the image several times, like a standing robot: carpet and white are learned in the earlier passes.
FieldPercept percept_of_still_image(const ImageView& image, const CameraModel& camera,
                                    const Isometry3& robot_from_camera, const FieldFeatureParameters& parameters,
                                    const FieldDimensions& field);

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "workbench/field_images/still_image.h"

namespace reorient {

FieldFeatureParameters for_still_image(FieldFeatureParameters parameters) {
  parameters.carpet_patience = 1;
  return parameters;
}

FieldPercept percept_of_still_image(const ImageView& image, const CameraModel& camera,
                                    const Isometry3& robot_from_camera, const FieldFeatureParameters& parameters,
                                    const FieldDimensions& field) {
  constexpr int kLooks = 5;
  FieldFeatures features(for_still_image(parameters), field);
  FieldPercept percept;
  for (int i = 0; i < kLooks; ++i) features.find(image, camera, robot_from_camera, percept);
  return percept;
}

}  // namespace reorient

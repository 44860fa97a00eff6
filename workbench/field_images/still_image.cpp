#include "workbench/field_images/still_image.h"

namespace reorient {

FieldPercept percept_of_still_image(const ImageView& image, const CameraModel& camera,
                                    const Isometry3& robot_from_camera, const FieldFeatureParameters& parameters,
                                    const FieldDimensions& field) {
  constexpr int kLooks = 5;  // since the carpet is known
  FieldFeatures features(parameters, field);
  FieldPercept percept;
  for (int i = 0, left = kLooks; i < CarpetColor::kPatience + kLooks && left > 0; ++i) {
    features.find(image, camera, robot_from_camera, percept);
    if (features.carpet_color().known()) --left;
  }
  return percept;
}

}  // namespace reorient

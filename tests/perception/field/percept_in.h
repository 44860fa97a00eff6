// SPDX-License-Identifier: MIT
// The percept of one image, as a value.
#pragma once

#include "geometry/transform.h"
#include "perception/field/field_features.h"

namespace reorient {

inline FieldPercept percept_in(FieldFeatures& features, const ImageView& image, const CameraModel& camera,
                               const Isometry3& robot_from_camera) {
  FieldPercept percept;
  features.find(image, camera, robot_from_camera, percept);
  return percept;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
// The fraction of a small patch of ground that lines cover. It is exact for straight lines and boxes of any size, so
// that lines neither flicker in the distance nor blur nearby. The field is symmetric, so one quarter of it is enough.
#pragma once

#include <vector>

#include "geometry/field_dimensions.h"

namespace reorient {

/// A row of ground patches: centers and half sizes along the field's axes, meters.
struct GroundPatches {
  const float* x = nullptr;
  const float* y = nullptr;
  const float* half_x = nullptr;
  const float* half_y = nullptr;
  int count = 0;
};

class FieldLines {
 public:
  /// `worn`: fraction of the lines that is missing, in patches.
  explicit FieldLines(const FieldDimensions& field, double worn = 0.0);

  /// Writes the fraction of each patch that lines cover, in [0, 1]. Reads and writes patches.count values.
  void cover(const GroundPatches& patches, float* coverage) const;

  /// The same for one patch.
  float cover(float x, float y, float half_x, float half_y) const;

 private:
  struct Strip {
    float low_x, high_x, low_y, high_y;  // of |x| and |y|
  };
  std::vector<Strip> strips_;
  float circle_radius_ = 0.0f;
  float corner_x_ = 0.0f, corner_y_ = 0.0f, corner_radius_ = 0.0f;
  float half_line_ = 0.0f;
  float worn_ = 0.0f;
};

}  // namespace reorient

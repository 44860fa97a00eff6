// SPDX-License-Identifier: MIT
// How much of a small patch of ground is line: exact for straight lines under a box of any size, so that lines neither
// flicker in the distance nor blur nearby. The field is symmetric, so one quarter of it is enough.
#pragma once

#include <vector>

#include "geometry/field_dimensions.h"

namespace reorient {

/// A row of ground patches: centres and half sizes along the field's axes, metres.
struct GroundPatches {
  const float* x = nullptr;
  const float* y = nullptr;
  const float* half_x = nullptr;
  const float* half_y = nullptr;
  int count = 0;
};

class FieldLines {
 public:
  /// `worn`: share of the lines that is gone, in patches.
  explicit FieldLines(const FieldDimensions& field, double worn = 0.0);

  /// Writes the share of every patch that is line, in [0, 1]. Reads and writes patches.count values.
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

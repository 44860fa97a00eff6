// SPDX-License-Identifier: MIT
// The evidence for the pose in each direction of a room, as a ring around the field.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/field_dimensions.h"
#include "workbench/views/pictures/canvas/canvas.h"

namespace reorient::pictures {

/// One column of the wall. Azimuths are seen from the field's center, in rad: 0 toward +x, counterclockwise.
struct RatedSector {
  double from = 0.0;      ///< its right side
  double to = 0.0;        ///< its left side, greater than `from`
  double log_odds = 0.0;  ///< evidence for the right pose; negative: against it
  double known = 1.0;     ///< fraction of the column that is learned
};

/// A position for a banner.
struct RatedBanner {
  double azimuth = 0.0;     ///< rad
  double half_width = 0.0;  ///< rad
};

struct RatingView {
  FieldDimensions field;
  std::string title;
  std::vector<std::string> notes;  ///< lines below the title
  std::vector<RatedSector> sectors;
  std::optional<RatedBanner> banner;
};

// Pixels of the picture.
inline constexpr int kRatingWidth = 1200;
inline constexpr int kRatingHeight = 1000;

Picture draw_rating(const RatingView& rating);

}  // namespace reorient::pictures

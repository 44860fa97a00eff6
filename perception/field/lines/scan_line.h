// SPDX-License-Identifier: MIT
// Bright segments along a line of luma values, used for field lines and goal posts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace reorient {

struct BrightSegment {
  double begin = 0.0;  ///< where luma rises and falls; positions between the values' indices
  double end = 0.0;
  int before =
      0;  ///< index of the last value outside of the rising edge, and of the first one outside of the falling edge
  int after = 0;
  int contrast = 0;  ///< its greatest value minus the greater one of the values on both sides
};

/// Finds segments between a rise and the next fall. An edge is a run of values whose slope over two steps is above
/// `least_slope`. Its position is the run's center of gravity. Segments are shorter than `most_length` and have at
/// least `least_contrast`.
void find_bright_segments(std::span<const std::int16_t> luma, int least_slope, int least_contrast, double most_length,
                          std::vector<BrightSegment>& segments);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Bright stretches along a line of luma values: the common ground of field lines and goal posts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace reorient {

struct BrightSegment {
  double begin = 0.0;  ///< where luma rises and where it falls again: places between the values' indices
  double end = 0.0;
  int before =
      0;  ///< index of the last value outside of the rising edge, and of the first one outside of the falling edge
  int after = 0;
  int contrast = 0;  ///< its brightest value above the brighter one of both sides
};

/// Stretches between a rise and the next fall. An edge is a run of values whose slope over two steps is above
/// `least_slope`; its place is the run's centre of gravity. Shorter than `most_length`, with at least `least_contrast`.
void find_bright_segments(std::span<const std::int16_t> luma, int least_slope, int least_contrast, double most_length,
                          std::vector<BrightSegment>& segments);

}  // namespace reorient

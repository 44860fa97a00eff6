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

struct SegmentLimits {
  int slope = 1;        ///< smallest difference, at an edge, between the values on both sides
  int reach = 1;        ///< distance of these two values from the edge; a blurred edge needs a larger one
  int contrast = 1;     ///< smallest value
  double length = 1.0;  ///< largest value
};

/// Finds segments between a rise and the next fall. An edge is a run of places with at least the limit's slope. Its
/// position is the run's center of gravity.
void find_bright_segments(std::span<const std::int16_t> luma, const SegmentLimits& limits,
                          std::vector<BrightSegment>& segments);

}  // namespace reorient

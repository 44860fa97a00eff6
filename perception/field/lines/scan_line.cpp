// SPDX-License-Identifier: MIT
#include "perception/field/lines/scan_line.h"

#include <algorithm>

namespace reorient {
namespace {

struct Edge {
  double place = 0.0;
  int before = -1;  ///< last index outside of the edge on either side
  int after = -1;
};

/// The run of slopes with one sign that starts at `first`.
template <typename Steep>
Edge follow_edge(std::span<const std::int16_t> luma, std::size_t first, std::size_t reach, Steep&& is_steep) {
  double weight = 0.0;
  double moment = 0.0;
  std::size_t i = first;
  for (; i + reach < luma.size(); ++i) {
    const int slope = luma[i + reach] - luma[i - reach];
    if (!is_steep(slope)) break;
    weight += slope;
    moment += static_cast<double>(slope) * static_cast<double>(i);
  }
  return {moment / weight, static_cast<int>(first) - 1, static_cast<int>(i)};
}

}  // namespace

void find_bright_segments(std::span<const std::int16_t> luma, const SegmentLimits& limits,
                          std::vector<BrightSegment>& segments) {
  const auto reach = static_cast<std::size_t>(limits.reach);
  const int least = limits.slope;
  segments.clear();
  Edge rise;
  for (std::size_t i = reach; i + reach < luma.size();) {
    const int slope = luma[i + reach] - luma[i - reach];
    if (slope >= least) {
      rise = follow_edge(luma, i, reach, [=](int s) { return s >= least; });
      i = static_cast<std::size_t>(rise.after);
    } else if (slope <= -least) {
      const Edge fall = follow_edge(luma, i, reach, [=](int s) { return s <= -least; });
      i = static_cast<std::size_t>(fall.after);
      if (rise.before < 0) continue;
      if (fall.place - rise.place <= limits.length) {
        const int top = *std::max_element(luma.begin() + rise.before, luma.begin() + fall.after + 1);
        const int contrast =
            top - std::max(luma[static_cast<std::size_t>(rise.before)], luma[static_cast<std::size_t>(fall.after)]);
        if (contrast >= limits.contrast)
          segments.push_back({rise.place, fall.place, rise.before, fall.after, contrast});
      }
      rise = {};
    } else {
      ++i;
    }
  }
}

}  // namespace reorient

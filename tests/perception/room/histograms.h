// SPDX-License-Identifier: MIT
// Histograms for tests.
#pragma once

#include <cstdint>

#include <rapidcheck.h>

#include "perception/room/color/color_histogram.h"

namespace reorient {

inline ColorHistogram all_in(int bin) {
  ColorHistogram histogram{};
  histogram[static_cast<std::size_t>(bin)] = 1.0f;
  return histogram;
}

/// For property tests.
inline ColorHistogram any_histogram() {
  ColorCounts counts{};
  for (auto& count : counts) count = *rc::gen::inRange<std::uint32_t>(0, 1000);
  counts[0] += 1;
  return normalized(counts);
}

}  // namespace reorient

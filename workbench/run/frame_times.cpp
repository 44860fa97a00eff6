#include "workbench/run/frame_times.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace reorient {

TimeQuantiles quantiles(std::vector<double> seconds) {
  if (seconds.empty()) return {};
  std::sort(seconds.begin(), seconds.end());
  // The nearest rank: the smallest value that is not less than this share of all.
  const auto rank = [&](double share) {
    const double place = std::ceil(share * static_cast<double>(seconds.size()));
    return seconds[static_cast<std::size_t>(std::max(1.0, place)) - 1];
  };
  return {rank(0.5), rank(0.99), seconds.back()};
}

}  // namespace reorient

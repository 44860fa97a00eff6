// SPDX-License-Identifier: MIT
// Selects some of many points, evenly.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace reorient {

/// Calls take(point) for at most `most` of the usable points, spread evenly over all of them.
template <typename Point, typename IsUsable, typename Take>
void for_some(const std::vector<Point>& points, std::size_t most, const IsUsable& is_usable, const Take& take) {
  const auto usable = static_cast<std::size_t>(std::count_if(points.begin(), points.end(), is_usable));
  const std::size_t count = std::min(usable, most);
  std::size_t seen = 0, taken = 0;
  for (const Point& point : points) {
    if (!is_usable(point)) continue;
    if (taken * usable <= seen * count && taken < count) {
      take(point);
      ++taken;
    }
    ++seen;
  }
}

}  // namespace reorient

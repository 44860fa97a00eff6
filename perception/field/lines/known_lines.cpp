// SPDX-License-Identifier: MIT
#include "perception/field/lines/known_lines.h"

#include <cmath>

#include "geometry/transform.h"

namespace reorient {

std::optional<int> KnownLines::at(const Eigen::Vector2d& place) const {
  constexpr double kExtension = 0.4;  // m beyond the known piece of a line
  const double half_width = line_width + 0.01 * place.norm();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Eigen::Vector2d offset = place - segments[i].from;
    if (std::abs(cross(segments[i].direction, offset)) > half_width) continue;
    const double along = offset.dot(segments[i].direction);
    if (along > -kExtension && along < segments[i].length + kExtension) return static_cast<int>(i);
  }
  const bool is_on_circle = circle && std::abs((place - circle->center).norm() - circle_radius) < half_width;
  return is_on_circle ? std::optional(kCenterCircle) : std::nullopt;
}

}  // namespace reorient

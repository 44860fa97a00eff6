// SPDX-License-Identifier: MIT
// The lines of one image on the ground, in one value. They are used to separate lines from objects on or in front of
// them.
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "perception/field/lines/line_segments.h"
#include "perception/field/percepts.h"

namespace reorient {

struct KnownLines {
  static constexpr int kCenterCircle = -1;

  std::span<const LineSegment> segments;
  std::optional<CenterCircle> circle;
  double circle_radius = 0.0;  ///< m
  double line_width = 0.0;     ///< m

  /// The line that may be at a position (m, robot frame): its number, or kCenterCircle. Empty if no line is
  /// there. Includes a margin, and a piece beyond the known ends.
  std::optional<int> at(const Eigen::Vector2d& place) const;
};

}  // namespace reorient

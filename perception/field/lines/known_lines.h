// SPDX-License-Identifier: MIT
// Where the lines of an image lie on the ground, in one value: what stands on a line or before it must not be mixed up
// with it.
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "perception/field/lines/line_segments.h"
#include "perception/field/percepts.h"

namespace reorient {

struct KnownLines {
  std::span<const LineSegment> segments;
  std::optional<CenterCircle> circle;
  double circle_radius = 0.0;  ///< m
  double line_width = 0.0;     ///< m

  /// The line that may lie at a place (m, robot frame): its number, -1 for the center circle; nothing: none. With a
  /// margin, and somewhat beyond the known ends.
  std::optional<int> at(const Eigen::Vector2d& place) const;
};

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Straight pieces of line, from the line points on them.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "perception/field/percepts.h"

namespace reorient {

/// Robot frame, m.
struct LineSegment {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< unit vector, from `from` to `to`
  double length = 0.0;
  int points = 0;
};

class LineSegments {
 public:
  LineSegments();

  /// The segments of all points except those on the circle. They are valid until the next call.
  std::span<const LineSegment> find(std::span<const LinePoint> points, const std::optional<CenterCircle>& circle,
                                    double circle_radius);

 private:
  struct Along {
    double place = 0.0;  ///< m from the seed along the line
    std::size_t point = 0;
  };
  /// The points of `on_line_` around the seed (at 0), up to the first gaps.
  std::span<const Along> run_around_seed();

  std::vector<LineSegment> segments_;
  std::vector<bool> used_;
  std::vector<Along> on_line_;
};

/// Whether a line point lies on the circle's line and has its direction there.
bool is_on_circle(const LinePoint& point, const Eigen::Vector2d& center, double radius);

}  // namespace reorient

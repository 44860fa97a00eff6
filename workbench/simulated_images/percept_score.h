// SPDX-License-Identifier: MIT
// How well the field vision finds what is in view: counts and errors of each kind of percept, by distance.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "perception/field/percepts.h"
#include "workbench/simulated_images/in_view.h"

namespace reorient {

enum class PerceptKind { line_points, goal_posts, center_circle, intersections, penalty_marks, ball, obstacles };
inline constexpr std::array<std::string_view, 7> kPerceptKinds{
    "line points", "goal posts", "center circle", "intersections", "marks", "ball", "obstacles"};

/// Of percepts in a range of distances. Errors are sums over those that are right.
struct PerceptCounts {
  int in_view = 0;              ///< things that are clearly in view
  int found = 0;                ///< of them, those of which there is a percept
  int reported = 0;             ///< percepts
  int right = 0;                ///< of them, those of something that is there
  int twisted = 0;              ///< of line points, those whose normal is not the line's
  double bearing_error = 0.0;   ///< rad, without its sign
  double distance_error = 0.0;  ///< share of the distance, without its sign
  int with_covariance = 0;      ///< of those that are right
  double squared_error = 0.0;   ///< normalized by the covariance: 2 on average where that is honest

  double recall() const { return in_view > 0 ? static_cast<double>(found) / in_view : 1.0; }
  double precision() const { return reported > 0 ? static_cast<double>(right) / reported : 1.0; }
};
PerceptCounts operator+(const PerceptCounts& a, const PerceptCounts& b);

struct PerceptScore {
  /// m; what is farther than the last belongs to no band.
  static constexpr std::array<double, 6> kBands{1.0, 2.0, 3.0, 4.5, 6.0, 9.0};

  std::array<std::array<PerceptCounts, kBands.size()>, kPerceptKinds.size()> counts{};
  int images = 0;

  /// Of the bands within these distances, m.
  PerceptCounts between(PerceptKind kind, double least, double most) const;
};
PerceptScore operator+(const PerceptScore& a, const PerceptScore& b);

/// `farthest`: m, things farther away than the vision looks for are not asked for.
PerceptScore score_of(const FieldPercept& percept, const FieldInView& view, const FieldDimensions& field,
                      const std::array<double, kPerceptKinds.size()>& farthest);

}  // namespace reorient

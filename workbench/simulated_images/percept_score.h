// SPDX-License-Identifier: MIT
// Scores the field vision: counts and errors of each type of percept, by distance.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "perception/field/field_feature_parameters.h"
#include "perception/field/percepts.h"
#include "workbench/simulated_images/in_view.h"

namespace reorient {

enum class PerceptKind {
  line_points,
  goal_posts,
  center_circle,
  intersections,
  corner_arcs,
  penalty_marks,
  ball,
  obstacles
};
inline constexpr std::array<std::string_view, 8> kPerceptKinds{
    "line points", "goal posts", "center circle", "intersections", "corner arcs", "marks", "ball", "obstacles"};

/// Score of the percepts in a range of distances. Errors are sums over right percepts.
struct PerceptCounts {
  int in_view = 0;              ///< things that are clearly in view
  int found = 0;                ///< of them, those with a percept
  int reported = 0;             ///< percepts
  int right = 0;                ///< of them, those of a real object
  int twisted = 0;              ///< line points whose normal is not that of the line
  double bearing_error = 0.0;   ///< rad, absolute
  double distance_error = 0.0;  ///< fraction of the distance, absolute
  int with_covariance = 0;      ///< of the right percepts
  double squared_error = 0.0;   ///< normalized by the covariance: 2 on average if that is correct

  double recall() const { return in_view > 0 ? static_cast<double>(found) / in_view : 1.0; }
  double precision() const { return reported > 0 ? static_cast<double>(right) / reported : 1.0; }
};
PerceptCounts operator+(const PerceptCounts& a, const PerceptCounts& b);

struct PerceptScore {
  /// m; objects beyond the last limit belong to no band.
  static constexpr std::array<double, 6> kBands{1.0, 2.0, 3.0, 4.5, 6.0, 9.0};

  std::array<std::array<PerceptCounts, kBands.size()>, kPerceptKinds.size()> counts{};
  int images = 0;

  /// Score of the bands within these distances, m.
  PerceptCounts between(PerceptKind kind, double least, double most) const;
};
PerceptScore operator+(const PerceptScore& a, const PerceptScore& b);

/// Objects beyond the ranges of the vision do not count.
PerceptScore score_of(const FieldPercept& percept, const FieldInView& view, const FieldDimensions& field,
                      const FieldFeatureParameters& parameters);

}  // namespace reorient

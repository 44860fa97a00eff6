// SPDX-License-Identifier: MIT
// Positions of the lines, posts, intersections and marks of a field: m, field frame.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "geometry/field_dimensions.h"

namespace reorient {

/// A straight piece of line, m, at the center of the line.
struct FieldLine {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
};

/// All straight lines of the field. The center circle and the penalty marks are not among them.
std::vector<FieldLine> field_lines(const FieldDimensions& field);

/// Appends the rectangles at both goals without their sides on the goal line. They reach `depth` into the field, or out
/// of it if `depth` is negative.
void add_areas(const FieldDimensions& field, double depth, double width, std::vector<FieldLine>& lines);

/// Left and right post of the opponent goal as seen from the field, then left and right post of the own goal.
/// Posts 0 and 2 are reflections of each other, and so are 1 and 3.
std::array<Eigen::Vector2d, 4> goal_posts(const FieldDimensions& field);

/// Ground points of one goal: the post at y > 0, the two corners of the net, the post at y < 0. `end`: 1 for the
/// opponent goal, -1 for the own goal.
std::array<Eigen::Vector2d, 4> goal_outline(const FieldDimensions& field, double end);

/// The quarter circle inside a corner of the field.
struct CornerArc {
  Eigen::Vector2d corner;  ///< its center
  double begin = 0.0;      ///< rad, direction from the corner to its start; it ends 90 degrees to the left
};

/// One arc in each corner. Empty if the radius is 0.
std::vector<CornerArc> corner_arcs(const FieldDimensions& field);

/// How two lines meet. L: both end. T: one ends at the other. X: both continue.
enum class IntersectionKind : std::uint8_t { l, t, x };

constexpr int enum_count(IntersectionKind) { return 3; }
/// "L", "T", "X".
constexpr const char* name_of(IntersectionKind kind) {
  return kind == IntersectionKind::l ? "L" : kind == IntersectionKind::t ? "T" : "X";
}

struct FieldIntersection {
  Eigen::Vector2d position;
  IntersectionKind kind = IntersectionKind::l;
  /// rad. L: between the two arms. T: along the line that ends, away from the other line. X: along any arm.
  double direction = 0.0;
};

/// The intersections of lines, of the center circle with the halfway line, and of corner arcs with the lines at which
/// they end. The reflection of each is in the list, too.
std::vector<FieldIntersection> field_intersections(const FieldDimensions& field);

/// Both penalty marks. Empty if marks have no size.
std::vector<Eigen::Vector2d> penalty_marks(const FieldDimensions& field);

}  // namespace reorient

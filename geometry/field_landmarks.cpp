// SPDX-License-Identifier: MIT
#include "geometry/field_landmarks.h"

#include "geometry/angle.h"
#include "geometry/transform.h"

namespace reorient {

void add_areas(const FieldDimensions& field, double depth, double width, std::vector<FieldLine>& lines) {
  if (depth == 0.0 || width <= 0.0) return;
  const double x = field_half_size(field).x();
  for (const double side : {1.0, -1.0}) {
    const double goal_line = side * x;
    const double front = side * (x - depth);
    lines.push_back({{front, width / 2.0}, {front, -width / 2.0}});
    lines.push_back({{goal_line, width / 2.0}, {front, width / 2.0}});
    lines.push_back({{goal_line, -width / 2.0}, {front, -width / 2.0}});
  }
}

std::vector<FieldLine> field_lines(const FieldDimensions& field) {
  const Eigen::Vector2d half = field_half_size(field);
  const double x = half.x(), y = half.y();
  std::vector<FieldLine> lines{
      {{-x, y}, {x, y}}, {{-x, -y}, {x, -y}}, {{x, -y}, {x, y}}, {{-x, -y}, {-x, y}}, {{0.0, -y}, {0.0, y}}};
  add_areas(field, field.penalty_area_depth, field.penalty_area_width, lines);
  add_areas(field, field.goal_area_depth, field.goal_area_width, lines);
  return lines;
}

std::array<Eigen::Vector2d, 4> goal_posts(const FieldDimensions& field) {
  const double x = field_half_size(field).x(), y = field.goal_post_y;
  return {{{x, y}, {x, -y}, {-x, -y}, {-x, y}}};
}

std::array<Eigen::Vector2d, 4> goal_outline(const FieldDimensions& field, double end) {
  const double front = end * field_half_size(field).x(), y = field.goal_post_y;
  const double back = front + end * field.goal_depth;
  return {{{front, y}, {back, y}, {back, -y}, {front, -y}}};
}

std::vector<CornerArc> corner_arcs(const FieldDimensions& field) {
  if (field.corner_arc_radius <= 0.0) return {};
  const Eigen::Vector2d half = field_half_size(field);
  const double x = half.x(), y = half.y();
  return {{{x, y}, kPi}, {{-x, y}, 1.5 * kPi}, {{-x, -y}, 0.0}, {{x, -y}, 0.5 * kPi}};
}

std::vector<FieldIntersection> field_intersections(const FieldDimensions& field) {
  using Eigen::Vector2d;
  const Vector2d half = field_half_size(field);
  const double x = half.x(), y = half.y();
  std::vector<FieldIntersection> intersections;
  const auto add = [&](const Vector2d& position, IntersectionKind kind, const Vector2d& direction) {
    intersections.push_back({position, kind, direction_of(direction)});
  };
  for (const double end : {1.0, -1.0}) {
    add({0.0, end * y}, IntersectionKind::t, {0.0, -end});
    if (field.center_circle_radius > 0.0) add({0.0, end * field.center_circle_radius}, IntersectionKind::x, {0.0, 1.0});
    for (const double side : {1.0, -1.0}) {
      add({end * x, side * y}, IntersectionKind::l, {-end, -side});
      const auto add_area = [&](double depth, double width) {
        if (depth <= 0.0 || width <= 0.0) return;
        add({end * x, 0.5 * side * width}, IntersectionKind::t, {-end, 0.0});
        add({end * (x - depth), 0.5 * side * width}, IntersectionKind::l, {end, -side});
      };
      add_area(field.penalty_area_depth, field.penalty_area_width);
      add_area(field.goal_area_depth, field.goal_area_width);
      const double arc = field.corner_arc_radius;
      if (arc <= 0.0) continue;
      add({end * (x - arc), side * y}, IntersectionKind::t, {0.0, -side});
      add({end * x, side * (y - arc)}, IntersectionKind::t, {-end, 0.0});
    }
  }
  return intersections;
}

std::vector<Eigen::Vector2d> penalty_marks(const FieldDimensions& field) {
  if (field.penalty_mark_size <= 0.0) return {};
  return {{field.penalty_mark_x, 0.0}, {-field.penalty_mark_x, 0.0}};
}

}  // namespace reorient

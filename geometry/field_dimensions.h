// SPDX-License-Identifier: MIT
// Measures of the field. Meters, to the centers of lines; origin at the center, x toward the opponent goal, y left.
#pragma once

#include <string>

#include <Eigen/Core>

#include "geometry/const_or.h"

namespace reorient {

/// The defaults are the current field of the Standard Platform League.
struct FieldDimensions {
  double length = 9.0;  ///< between the goal lines
  double width = 6.0;   ///< between the touchlines
  double border = 0.7;  ///< width of the carpet beyond the lines
  double line_width = 0.05;
  double penalty_area_depth = 1.65;
  double penalty_area_width = 4.0;
  double goal_area_depth = 0.6;  ///< 0: no goal area (2013)
  double goal_area_width = 2.2;
  double penalty_mark_x = 3.2;  ///< distance of both marks from the center
  double penalty_mark_size = 0.1;
  double center_circle_radius = 0.75;
  double corner_arc_radius = 0.0;  ///< of the quarter circles at the corners; 0: no arcs
  double goal_post_y = 0.8;        ///< posts at y = +-goal_post_y on the goal lines
  double goal_height = 0.8;
  double goal_depth = 0.5;  ///< distance from the goal line to the back of the net
  double goal_post_diameter = 0.1;
  double ball_diameter = 0.1;
  bool yellow_goals = false;  ///< 2013: both goals yellow; today: both white
};

/// From the center to the goal lines and to the touchlines, m.
inline Eigen::Vector2d field_half_size(const FieldDimensions& field) { return {0.5 * field.length, 0.5 * field.width}; }

/// Half of the carpet's length and width, m.
inline Eigen::Vector2d carpet_half_size(const FieldDimensions& field) {
  return field_half_size(field) + Eigen::Vector2d::Constant(field.border);
}

/// Distance from the carpet up to which a robot may stand beside it, m.
inline constexpr double kBelievableBeyondCarpet = 1.0;

/// Largest distance from the center of a believed pose, m.
inline Eigen::Vector2d believable_half_size(const FieldDimensions& field) {
  return carpet_half_size(field) + Eigen::Vector2d::Constant(kBelievableBeyondCarpet);
}

/// Calls visit(key, length, least, most) for each length, with the range of possible values.
template <ConstOr<FieldDimensions> T, typename Visit>
void describe(T& field, Visit&& visit) {
  visit("length", field.length, 2.0, 120.0);
  visit("width", field.width, 1.0, 90.0);
  visit("border", field.border, 0.0, 10.0);
  visit("line_width", field.line_width, 0.01, 0.3);
  visit("penalty_area_depth", field.penalty_area_depth, 0.0, 20.0);
  visit("penalty_area_width", field.penalty_area_width, 0.0, 60.0);
  visit("goal_area_depth", field.goal_area_depth, 0.0, 20.0);
  visit("goal_area_width", field.goal_area_width, 0.0, 60.0);
  visit("penalty_mark_x", field.penalty_mark_x, 0.0, 60.0);
  visit("penalty_mark_size", field.penalty_mark_size, 0.0, 0.5);
  visit("center_circle_radius", field.center_circle_radius, 0.0, 10.0);
  visit("corner_arc_radius", field.corner_arc_radius, 0.0, 10.0);
  visit("goal_post_y", field.goal_post_y, 0.2, 5.0);
  visit("goal_height", field.goal_height, 0.2, 5.0);
  visit("goal_depth", field.goal_depth, 0.0, 5.0);
  visit("goal_post_diameter", field.goal_post_diameter, 0.02, 0.5);
  visit("ball_diameter", field.ball_diameter, 0.03, 0.5);
}

template <typename Visit, ConstOr<FieldDimensions> T>
void fields(Visit&& visit, T& field) {
  describe(field, [&](const char*, auto& value, const auto&...) { visit(value); });
  visit(field.yellow_goals);
}

/// The first length outside of its range, with that range, or an empty string.
inline std::string mistake_in(const FieldDimensions& field) {
  std::string mistake;
  describe(field, [&](const char* key, double value, double least, double most) {
    // Written so that NaN fails, too.
    if (!mistake.empty() || (value >= least && value <= most)) return;
    const auto number = [](double limit) {
      std::string text = std::to_string(limit);
      text.erase(text.find_last_not_of('0') + 1);
      return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
    };
    mistake = "'" + std::string(key) + "' must be a number from " + number(least) + " to " + number(most) + " meters";
  });
  return mistake;
}

}  // namespace reorient

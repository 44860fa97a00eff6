// SPDX-License-Identifier: MIT
// Where the ball has left the field, by the rules: it is out, or in a goal, when all of it has crossed the line.
#pragma once

#include <cmath>
#include <optional>

#include "geometry/field_dimensions.h"
#include "robots/simulator/ball/rolling_ball.h"

namespace reorient {

struct FieldExit {
  enum class Line { goal, goal_line, touchline };
  Line line = Line::touchline;
  double side = 1.0;  ///< 1 or -1: sign of x of a goal or goal line, of y of a touchline
};

/// Nothing: the ball is on the field.
inline std::optional<FieldExit> exit_of(const RollingBall& ball, const FieldDimensions& field) {
  const Eigen::Vector2d line = field_half_size(field) + Eigen::Vector2d::Constant(0.5 * field.line_width + ball.radius);
  if (std::abs(ball.position.x()) > line.x()) {
    const bool is_between_posts = std::abs(ball.position.y()) < field.goal_post_y;
    return FieldExit{is_between_posts ? FieldExit::Line::goal : FieldExit::Line::goal_line,
                     std::copysign(1.0, ball.position.x())};
  }
  if (std::abs(ball.position.y()) > line.y())
    return FieldExit{FieldExit::Line::touchline, std::copysign(1.0, ball.position.y())};
  return std::nullopt;
}

}  // namespace reorient

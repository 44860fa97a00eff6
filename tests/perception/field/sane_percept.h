// SPDX-License-Identifier: MIT
// Invariants of every percept, for any image.
#pragma once

#include <cmath>
#include <string>

#include "perception/field/carpet/carpet_map.h"
#include "perception/field/percepts.h"

namespace reorient {

inline bool is_covariance(const Eigen::Matrix2d& matrix) {
  constexpr double kRounding = 1e-9;
  const double scale = matrix(0, 0) * matrix(1, 1);
  return matrix.allFinite() && matrix(0, 0) >= 0.0 && matrix(1, 1) >= 0.0 &&
         std::abs(matrix(0, 1) - matrix(1, 0)) <= kRounding * std::sqrt(scale) &&
         matrix.determinant() >= -kRounding * scale;
}

/// What is impossible in the percept of an image of this size. Empty if it is valid.
inline std::string mistake_in(const FieldPercept& percept, int width, int height) {
  const auto is_inside = [&](const Eigen::Vector2f& pixel) {
    return pixel.x() >= 0.0f && pixel.x() < static_cast<float>(width) && pixel.y() >= 0.0f &&
           pixel.y() < static_cast<float>(height);
  };
  if (percept.boundary.size() != static_cast<std::size_t>(CarpetMap::kColumns)) return "the boundary has a wrong size";
  for (const float row : percept.boundary) {
    if (!(row >= 0.0f && row <= static_cast<float>(height))) return "a boundary outside of the image";
  }
  for (const LinePoint& point : percept.line_points) {
    if (!point.position.allFinite() || !(std::abs(point.normal) <= 3.2)) return "a line point with an invalid position";
    if (!is_inside(point.pixel)) return "a line point outside of the image";
  }
  for (const GoalPost& post : percept.goal_posts) {
    if (!post.position.allFinite() || !post.base.allFinite() || !post.top.allFinite())
      return "a post with an invalid position";
  }
  for (const Obstacle& obstacle : percept.obstacles) {
    if (!obstacle.position.allFinite()) return "an obstacle with an invalid position";
    if (!(0 <= obstacle.left && obstacle.left <= obstacle.right && obstacle.right < width && 0 <= obstacle.top &&
          obstacle.top <= obstacle.bottom && obstacle.bottom < height)) {
      return "an obstacle outside of the image";
    }
  }
  if (const auto& circle = percept.center_circle) {
    if (!circle->center.allFinite() || !is_covariance(circle->covariance))
      return "a center circle with an invalid position";
    if (circle->halfway_direction && !(std::abs(*circle->halfway_direction) <= 3.2))
      return "a halfway line with an invalid direction";
    if (!(circle->direction_variance >= 0.0)) return "a halfway line with an invalid variance";
  }
  for (const Intersection& intersection : percept.intersections) {
    if (!intersection.position.allFinite() || !std::isfinite(intersection.direction) ||
        !is_covariance(intersection.covariance)) {
      return "an intersection with an invalid position";
    }
  }
  for (const PenaltyMark& mark : percept.penalty_marks) {
    if (!mark.position.allFinite() || !is_covariance(mark.covariance)) return "a penalty mark with an invalid position";
    if (!is_inside(mark.pixel)) return "a penalty mark outside of the image";
  }
  if (const auto& ball = percept.ball) {
    if (!ball->position.allFinite() || !is_covariance(ball->covariance)) return "a ball with an invalid position";
    if (!ball->pixel.allFinite() || !(ball->radius > 0.0f)) return "a ball with an invalid position in the image";
  }
  return "";
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "perception/field/lines/hiding.h"

#include <cmath>

namespace reorient {

bool hides(const FieldPercept& percept, const Eigen::Vector2d& pixel) {
  constexpr double kMargin = 2.0;  // pixels
  for (const Obstacle& obstacle : percept.obstacles) {
    if (pixel.x() >= obstacle.left - kMargin && pixel.x() <= obstacle.right + kMargin &&
        pixel.y() <= obstacle.bottom + kMargin) {
      return true;
    }
  }
  for (const GoalPost& post : percept.goal_posts) {
    const double half = 0.1 * (post.base.y() - post.top.y()) + kMargin;
    if (std::abs(pixel.x() - post.base.x()) <= half && pixel.y() <= post.base.y() + kMargin) return true;
  }
  return percept.ball &&
         (pixel - percept.ball->pixel.cast<double>()).norm() <= static_cast<double>(percept.ball->radius) + kMargin;
}

}  // namespace reorient

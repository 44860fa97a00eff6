// SPDX-License-Identifier: MIT
#include "engine/covered_areas.h"

#include <algorithm>

namespace reorient {

void collect_covered(const FieldPercept& percept, std::vector<CoveredArea>& covered) {
  covered.clear();
  for (const Obstacle& obstacle : percept.obstacles) {
    covered.push_back({obstacle.left, obstacle.top, obstacle.right, obstacle.bottom});
  }
  for (const GoalPost& post : percept.goal_posts) {
    const auto [left, right] = std::minmax(post.base.x(), post.top.x());
    const float half_width = 0.1f * (post.base.y() - post.top.y());  // half width of a post relative to its height
    covered.push_back({static_cast<int>(left - half_width), static_cast<int>(post.top.y()),
                       static_cast<int>(right + half_width), static_cast<int>(post.base.y())});
  }
}

}  // namespace reorient

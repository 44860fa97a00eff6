#include "localization/measurement/both_cameras.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"

namespace reorient {
namespace {

constexpr double kSameBearing = 0.08;  // rad; two posts of a goal are never seen as near to each other
constexpr double kSamePlace = 0.5;     // m, where both bases are seen

double bearing(const GoalPost& post) { return pinned::atan2(post.position.y(), post.position.x()); }

bool is_same(const GoalPost& upper, const GoalPost& lower) {
  if (std::abs(angle_difference(bearing(upper), bearing(lower))) > kSameBearing) return false;
  return !upper.base_visible || !lower.base_visible || (upper.position - lower.position).norm() < kSamePlace;
}

}  // namespace

void merge(const FieldPercept& upper, const FieldPercept& lower, FieldPercept& merged) {
  merged.clear();
  merged.line_points.insert(merged.line_points.end(), upper.line_points.begin(), upper.line_points.end());
  merged.line_points.insert(merged.line_points.end(), lower.line_points.begin(), lower.line_points.end());
  merged.goal_posts.insert(merged.goal_posts.end(), upper.goal_posts.begin(), upper.goal_posts.end());
  for (const GoalPost& post : lower.goal_posts) {
    const auto twin = std::find_if(merged.goal_posts.begin(), merged.goal_posts.end(),
                                   [&](const GoalPost& other) { return is_same(other, post); });
    if (twin == merged.goal_posts.end()) {
      merged.goal_posts.push_back(post);
    } else if (post.base_visible) {
      *twin = post;
    }
  }
}

}  // namespace reorient

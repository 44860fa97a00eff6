// SPDX-License-Identifier: MIT
#include "localization/measurement/both_cameras.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"

namespace reorient {
namespace {

constexpr double kSameBearing = 0.08;  // rad; the two posts of a goal never appear so close together
constexpr double kSamePlace = 0.5;     // m; two posts, or two landmarks of one type, are never so close together

double bearing(const GoalPost& post) { return pinned::atan2(post.position.y(), post.position.x()); }

bool is_same(const GoalPost& upper, const GoalPost& lower) {
  if (std::abs(angle_difference(bearing(upper), bearing(lower))) > kSameBearing) return false;
  return !upper.base_visible || !lower.base_visible || (upper.position - lower.position).norm() < kSamePlace;
}

template <typename Seen>
bool is_surer(const Seen& one, const Seen& other) {
  return one.covariance.trace() < other.covariance.trace();
}

/// Merges a landmark that exists only once on the field.
template <typename Seen>
std::optional<Seen> surer(const std::optional<Seen>& upper, const std::optional<Seen>& lower) {
  if (!upper || !lower) return upper ? upper : lower;
  return is_surer(*lower, *upper) ? lower : upper;
}

template <typename Seen>
void add(const std::vector<Seen>& lower, std::vector<Seen>& merged) {
  for (const Seen& one : lower) {
    const auto twin = std::find_if(merged.begin(), merged.end(), [&](const Seen& other) {
      return (other.position - one.position).norm() < kSamePlace;
    });
    if (twin == merged.end()) {
      merged.push_back(one);
    } else if (is_surer(one, *twin)) {
      *twin = one;
    }
  }
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
  merged.center_circle = surer(upper.center_circle, lower.center_circle);
  merged.ball = surer(upper.ball, lower.ball);
  merged.intersections.assign(upper.intersections.begin(), upper.intersections.end());
  add(lower.intersections, merged.intersections);
  merged.penalty_marks.assign(upper.penalty_marks.begin(), upper.penalty_marks.end());
  add(lower.penalty_marks, merged.penalty_marks);
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "localization/measurement/goal_injection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/angle.h"
#include "geometry/field_landmarks.h"
#include "geometry/transform.h"
#include "localization/measurement/disturbed_place.h"

namespace reorient {
namespace {

bool usable(const GoalPost& post, double farthest) {
  const double distance = post.position.norm();
  return distance > 0.1 && distance <= farthest;  // false where it is not finite
}

}  // namespace

GoalInjection::GoalInjection(const FieldDimensions& field)
    : posts_(goal_posts(field)), carpet_(carpet_half_size(field)) {}

std::optional<GoalSighting> GoalInjection::find_goal(const FieldPercept& percept, const MeasurementModel& observed,
                                                     const InjectionParameters& parameters) const {
  std::optional<GoalSighting> found;
  const double width = (posts_[0] - posts_[1]).norm();
  double least_error = parameters.goal_width_tolerance;
  double nearest = std::numeric_limits<double>::infinity();
  const std::vector<GoalPost>& posts = percept.goal_posts;
  const double farthest = observed.parameters().farthest_goal_post;
  for (std::size_t i = 0; i < posts.size(); ++i) {
    if (!usable(posts[i], farthest)) continue;
    for (std::size_t j = i + 1; j < posts.size(); ++j) {
      if (!usable(posts[j], farthest)) continue;
      const Eigen::Vector2d& a = posts[i].position;
      const Eigen::Vector2d& b = posts[j].position;
      const double error = std::abs((a - b).norm() - width);
      if (error > least_error) continue;
      least_error = error;
      const bool b_is_left = a.x() * b.y() - a.y() * b.x() > 0.0;
      found = b_is_left ? GoalSighting{b, a} : GoalSighting{a, b};
    }
    const bool single = !(found && found->right) && posts[i].base_visible &&
                        observed.line_points() >= static_cast<std::size_t>(parameters.line_points_with_one_post);
    if (single && posts[i].position.norm() < nearest) {
      nearest = posts[i].position.norm();
      found = GoalSighting{posts[i].position, std::nullopt};
    }
  }
  return found;
}

std::optional<Pose2> GoalInjection::draw_candidate(const GoalSighting& sighting, bool opponent_goal,
                                                   const MeasurementModel& observed, Random& random) const {
  const std::size_t first = opponent_goal ? 0 : 2;
  const Eigen::Vector2d seen_left = disturbed(sighting.left, observed, random);
  Pose2 pose;
  if (sighting.right) {
    const Eigen::Vector2d seen_right = disturbed(*sighting.right, observed, random);
    pose.rotation =
        angle_difference(direction_of(posts_[first + 1] - posts_[first]), direction_of(seen_right - seen_left));
    pose.position = (posts_[first] + posts_[first + 1]) / 2.0 - rotated((seen_left + seen_right) / 2.0, pose.rotation);
  } else {
    const Eigen::Vector2d& post = posts_[first + random.below(2)];
    const double away = random.uniform(-kPi, kPi);  // from the post to the robot, in the field
    pose.position = post + seen_left.norm() * unit_vector(away);
    pose.rotation = angle_difference(away + kPi, direction_of(seen_left));
  }
  const bool is_on_carpet = (pose.position.cwiseAbs().array() <= carpet_.array()).all();
  return is_on_carpet ? std::optional(pose) : std::nullopt;
}

std::optional<Pose2> GoalInjection::draw(const GoalSighting& sighting, SeenGoal seen_goal,
                                         const MeasurementModel& observed, const InjectionParameters& parameters,
                                         Random& random) {
  const bool opponent_goal = seen_goal == SeenGoal::unknown ? random.below(2) == 0 : seen_goal == SeenGoal::opponent;
  const auto count = static_cast<std::size_t>(std::max(1, parameters.candidates));
  const auto best =
      best_.choose(count, observed, [&] { return draw_candidate(sighting, opponent_goal, observed, random); });
  return best ? std::optional(best->pose) : std::nullopt;
}

}  // namespace reorient

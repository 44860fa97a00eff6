// SPDX-License-Identifier: MIT
// New pose particles where a goal was seen (the paper's Section 4).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/field_dimensions.h"
#include "geometry/random.h"
#include "localization/measurement/best_candidate.h"
#include "localization/measurement/measurement_model.h"
#include "localization/pose_belief.h"
#include "perception/field/percepts.h"

namespace reorient {

/// Rates are shares of all particles, replaced in a frame that shows a goal.
struct InjectionParameters {
  bool enabled = true;
  double unknown_goal_rate = 0.0002;
  double known_goal_rate = 0.03;
  double lost_rate = 0.1;
  double slow_time = 60.0;
  double fast_time = 0.7;
  double lost_margin = 0.6;
  double blind_time = 10.0;
  bool use_landmarks = true;
  bool use_view = true;
  int line_points_with_view = 20;
  int candidates = 25;
  double goal_width_tolerance = 0.5;
  int line_points_with_one_post = 8;
};

template <typename Visit>
void describe(InjectionParameters& p, Visit&& visit) {
  visit("enabled", p.enabled, "draw new particles where a goal is seen");
  visit("unknown_goal_rate", p.unknown_goal_rate, 0.0, 0.5, "", "share renewed while it is unknown which goal is seen");
  visit("known_goal_rate", p.known_goal_rate, 0.0, 0.5, "", "share renewed while it is known which goal is seen");
  visit("lost_rate", p.lost_rate, 0.0, 0.5, "", "share renewed on top of that when nothing fits any more");
  visit("slow_time", p.slow_time, 1.0, 600.0, "s", "time over which the usual fit of the particles is learnt");
  visit("fast_time", p.fast_time, 0.05, 60.0, "s", "time over which their present fit is averaged");
  visit("lost_margin", p.lost_margin, 0.05, 1.0, "",
        "the robot counts as lost once the present fit is below this share of the usual");
  visit("blind_time", p.blind_time, 1.0, 600.0, "s",
        "time in which the present fit fades while the robot looks and sees nothing of the field");
  visit("use_landmarks", p.use_landmarks,
        "whether a lost robot gets poses from intersections and the center circle, without a goal, too");
  visit("use_view", p.use_view,
        "whether a lost robot gets headings from where the room says that the camera looks, without a goal, too");
  visit("line_points_with_view", p.line_points_with_view, 0, 200, "",
        "how many line points must be seen for a place to be drawn without a goal");
  visit("candidates", p.candidates, 1, 100, "", "how many poses are drawn for each new particle; the best is taken");
  visit("goal_width_tolerance", p.goal_width_tolerance, 0.05, 1.5, "m",
        "two posts make a goal when their distance is right within this");
  visit("line_points_with_one_post", p.line_points_with_one_post, 0, 200, "",
        "one post alone is enough when this many line points are seen with it");
}

/// A goal as one frame shows it, robot frame, m. With one post only nobody knows which of the two it is.
struct GoalSighting {
  Eigen::Vector2d left = Eigen::Vector2d::Zero();
  std::optional<Eigen::Vector2d> right;
};

/// Draws poses from which a goal would be seen where it was seen.
class GoalInjection {
 public:
  explicit GoalInjection(const FieldDimensions& field);

  /// The goal in the observed frame, if there is one: the two posts whose distance fits a goal best, or else the
  /// nearest post whose base is in view when there are enough lines to go with it. Of posts as far as the model that
  /// has observed the percept uses them.
  std::optional<GoalSighting> find_goal(const FieldPercept& percept, const MeasurementModel& observed,
                                        const InjectionParameters& parameters) const;

  /// A pose that explains the sighting and, of some drawn at random, the rest of the observations best. While the goal
  /// is unknown both goals are equally likely. Nothing where all of the drawn poses would be off the carpet.
  std::optional<Pose2> draw(const GoalSighting& sighting, SeenGoal seen_goal, const MeasurementModel& observed,
                            const InjectionParameters& parameters, Random& random);

 private:
  std::optional<Pose2> draw_candidate(const GoalSighting& sighting, bool opponent_goal,
                                      const MeasurementModel& observed, Random& random) const;

  std::array<Eigen::Vector2d, 4> posts_;
  Eigen::Vector2d carpet_;  // half of its size, m
  BestCandidate best_;
};

}  // namespace reorient

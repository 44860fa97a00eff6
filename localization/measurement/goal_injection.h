// SPDX-License-Identifier: MIT
// New pose particles from a goal in view (the paper's Section 4).
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

/// Rates are fractions of all particles, replaced in each frame that shows a goal.
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
  visit("enabled", p.enabled, "whether new particles are drawn when a goal is in view");
  visit("unknown_goal_rate", p.unknown_goal_rate, 0.0, 0.5, "",
        "fraction of the particles replaced in a frame with an unknown goal");
  visit("known_goal_rate", p.known_goal_rate, 0.0, 0.5, "",
        "fraction of the particles replaced in a frame with a known goal");
  visit("lost_rate", p.lost_rate, 0.0, 0.5, "",
        "additional fraction of the particles replaced in a frame when nothing fits any more");
  visit("slow_time", p.slow_time, 1.0, 600.0, "s", "time constant of the usual fit of the particles");
  visit("fast_time", p.fast_time, 0.05, 60.0, "s", "time constant of the present fit of the particles");
  visit("lost_margin", p.lost_margin, 0.05, 1.0, "",
        "fraction of the usual fit; the robot counts as lost when the present fit is below it");
  visit("blind_time", p.blind_time, 1.0, 600.0, "s",
        "time constant with which the present fit fades while nothing of the field is in view");
  visit("use_landmarks", p.use_landmarks,
        "whether a lost robot also gets poses from intersections and the center circle, without a goal");
  visit("use_view", p.use_view,
        "whether a lost robot also gets headings from the view that room awareness estimates, without a goal");
  visit("line_points_with_view", p.line_points_with_view, 0, 200, "",
        "smallest number of line points in view for poses drawn from the view, without a goal");
  visit("candidates", p.candidates, 1, 100, "",
        "number of poses drawn for each new particle, of which the best is used");
  visit("goal_width_tolerance", p.goal_width_tolerance, 0.05, 1.5, "m",
        "largest error of the distance between two posts that count as a goal");
  visit("line_points_with_one_post", p.line_points_with_one_post, 0, 200, "",
        "smallest number of line points in view for poses drawn from one post alone");
}

/// A goal as seen in one frame, m, robot frame. With one post only, it is unknown which of the two it is.
struct GoalSighting {
  Eigen::Vector2d left = Eigen::Vector2d::Zero();
  std::optional<Eigen::Vector2d> right;
};

/// Draws poses that agree with the observed position of a goal.
class GoalInjection {
 public:
  explicit GoalInjection(const FieldDimensions& field);

  /// The goal in the percept, if any: the two posts whose distance fits a goal best, or else the nearest post with its
  /// base in view if enough line points are in view. Considers posts up to the largest distance of `observed`.
  std::optional<GoalSighting> find_goal(const FieldPercept& percept, const MeasurementModel& observed,
                                        const InjectionParameters& parameters) const;

  /// Draws some random poses that explain the sighting, and returns the one that explains the other observations
  /// best. If the goal is unknown, both are equally likely. Empty if all of the poses would be off the carpet.
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

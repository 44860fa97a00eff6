// SPDX-License-Identifier: MIT
// Recognizes which goal is in view by the room behind it (the paper's goal views, end of Section 3.4).
#pragma once

#include "localization/pose_belief.h"
#include "perception/room/room_awareness.h"

namespace reorient {

struct GoalViewParameters {
  double least = 0.2;
  double lead = 2.0;
};

template <typename Visit>
void describe(GoalViewParameters& p, Visit&& visit) {
  visit("least", p.least, 0.0, 1.0, "", "smallest fraction of view particles behind a goal at which it is recognized");
  visit("lead", p.lead, 1.0, 10.0, "",
        "smallest ratio of the particles behind the recognized goal to those behind the other goal");
}

inline SeenGoal seen_goal(const Confidences& confidence, const GoalViewParameters& parameters) {
  const auto wins = [&](double goal, double other) {
    return goal >= parameters.least && goal >= parameters.lead * other;
  };
  if (wins(confidence.goal_opponent, confidence.goal_own)) return SeenGoal::opponent;
  if (wins(confidence.goal_own, confidence.goal_opponent)) return SeenGoal::own;
  return SeenGoal::unknown;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "engine/world/goal_view.h"

#include <utility>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

SeenGoal seen(double opponent, double own, const GoalViewParameters& parameters = {}) {
  Confidences confidence;
  confidence.goal_opponent = opponent;
  confidence.goal_own = own;
  return seen_goal(confidence, parameters);
}

TEST(GoalView, IsUnknownWithoutParticlesBehindAGoal) { EXPECT_EQ(seen(0.0, 0.0), SeenGoal::unknown); }

TEST(GoalView, IsTheGoalWithEnoughParticlesBehindIt) {
  EXPECT_EQ(seen(0.6, 0.1), SeenGoal::opponent);
  EXPECT_EQ(seen(0.1, 0.6), SeenGoal::own);
}

TEST(GoalView, IsUnknownBelowTheSmallestFraction) {
  EXPECT_EQ(seen(0.2, 0.0), SeenGoal::opponent);
  EXPECT_EQ(seen(0.199, 0.0), SeenGoal::unknown);
}

TEST(GoalView, IsUnknownIfTheRatioToTheOtherGoalIsTooSmall) {
  EXPECT_EQ(seen(0.6, 0.3), SeenGoal::opponent);
  EXPECT_EQ(seen(0.6, 0.31), SeenGoal::unknown);
}

TEST(GoalView, IsUnknownIfBothGoalsHaveTheSameFraction) {
  GoalViewParameters parameters;
  parameters.lead = 1.001;
  EXPECT_EQ(seen(0.5, 0.5, parameters), SeenGoal::unknown);
}

RC_GTEST_PROP(GoalViewProperty, SwapsWithTheGoals, ()) {
  const double a = *rc::gen::inRange(0, 101) / 100.0;
  const double b = *rc::gen::inRange(0, 101) / 100.0;
  const SeenGoal forwards = seen(a, b), backwards = seen(b, a);
  RC_ASSERT((forwards == SeenGoal::opponent) == (backwards == SeenGoal::own));
  RC_ASSERT((forwards == SeenGoal::unknown) == (backwards == SeenGoal::unknown));
}

}  // namespace
}  // namespace reorient

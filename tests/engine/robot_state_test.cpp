#include "engine/world/robot_state.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

constexpr double kStep = 1.0 / 30.0;

BodySample felt(double load, double roll = 0.0, double pitch = 0.0) {
  BodySample observation;
  observation.foot_load = load;
  observation.torso = {roll, pitch};
  return observation;
}

class BodyState : public ::testing::Test {
 protected:
  void feel(const BodySample& observation, double seconds = kStep) {
    for (double time = 0.0; time < seconds - 1e-9; time += kStep) state.update(observation, kStep, parameters);
  }

  RobotStateParameters parameters;
  RobotState state;
};

TEST_F(BodyState, StartsUprightAndStaysSoUnderItsWeight) {
  EXPECT_TRUE(state.upright());
  feel(felt(5.3), 2.0);
  EXPECT_TRUE(state.upright());
}

TEST_F(BodyState, IsFallenAtOnceBeyondTheAngleToAnySide) {
  for (const double sign : {-1.0, 1.0}) {
    feel(felt(5.3, sign * 0.79, 0.0));
    EXPECT_FALSE(state.fallen());
    feel(felt(5.3, sign * 0.81, 0.0));
    EXPECT_TRUE(state.fallen());
    feel(felt(5.3, 0.0, sign * 0.79));
    EXPECT_FALSE(state.fallen());
    feel(felt(5.3, 0.0, sign * 0.81));
    EXPECT_TRUE(state.fallen());
    EXPECT_FALSE(state.upright());
  }
}

TEST_F(BodyState, IsCarriedOnceItsFeetHaveBeenFreeForTheSettleTime) {
  feel(felt(0.2), 0.1);
  EXPECT_FALSE(state.carried());
  feel(felt(0.2), 0.1);
  EXPECT_TRUE(state.carried());
  EXPECT_FALSE(state.upright());
}

TEST_F(BodyState, IsPutDownOnceItsFeetHaveBornItForTheSettleTime) {
  feel(felt(0.2), 1.0);
  ASSERT_TRUE(state.carried());
  feel(felt(5.0), 0.1);
  EXPECT_TRUE(state.carried());
  feel(felt(5.0), 0.1);
  EXPECT_TRUE(state.upright());
}

TEST_F(BodyState, DoesNotTakeStepsForBeingCarried) {
  for (int step = 0; step < 50; ++step) {
    feel(felt(0.2), 0.1);
    feel(felt(5.3), kStep);
    ASSERT_FALSE(state.carried());
  }
}

TEST_F(BodyState, IsFallenAndNotCarriedWhenItLiesWithFreeFeet) {
  feel(felt(0.0, 0.0, 1.5), 2.0);
  EXPECT_TRUE(state.fallen());
  EXPECT_FALSE(state.carried());
}

TEST_F(BodyState, ThatWasCarriedIsLaidDownAsFallen) {
  feel(felt(0.0), 1.0);
  ASSERT_TRUE(state.carried());
  feel(felt(0.0, 1.5, 0.0), 0.3);
  EXPECT_TRUE(state.fallen());
  EXPECT_FALSE(state.carried());
}

RC_GTEST_PROP(BodyStateProperty, IsUprightExactlyWhenItIsNeitherFallenNorCarried, ()) {
  RobotState state;
  const RobotStateParameters parameters;
  for (int frame = 0; frame < 60; ++frame) {
    const auto load = *rc::gen::inRange(0, 6);
    const auto tilt = *rc::gen::inRange(-15, 16);
    state.update(felt(load, 0.0, 0.1 * tilt), kStep, parameters);
    RC_ASSERT(state.upright() == (!state.fallen() && !state.carried()));
    RC_ASSERT(state.fallen() == (std::abs(0.1 * tilt) > parameters.fallen_angle));
  }
}

}  // namespace
}  // namespace reorient

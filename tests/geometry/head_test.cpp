#include "geometry/head.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

TEST(Head, OfAStandingRobotCarriesItsCameraHalfAMetreUp) {
  const RobotDimensions nao;
  const Isometry3 camera = robot_from_camera(nao, {}, {}, nao.hip_height);
  EXPECT_NEAR(camera.translation().z(), 0.523, 0.001);
  EXPECT_NEAR(camera.translation().x(), 0.0587, 0.001);
}

TEST(Head, TurnedLeftLooksLeft) {
  const RobotDimensions nao;
  const Isometry3 camera = robot_from_camera(nao, {kPi / 2.0, 0.0}, {}, nao.hip_height);
  EXPECT_GT(camera.linear().col(0).y(), 0.99);
}

TEST(Head, PitchedForwardLooksDown) {
  const RobotDimensions nao;
  EXPECT_LT(robot_from_camera(nao, {0.0, 0.3}, {}, nao.hip_height).linear().col(0).z(), -0.29);
  EXPECT_LT(robot_from_camera(nao, {}, {0.0, 0.3}, nao.hip_height).linear().col(0).z(), -0.29);
}

TEST(Head, PitchRangeMeetsTheTableAndTheMiddleBetweenItsRows) {
  EXPECT_DOUBLE_EQ(head_pitch_range(0.0).max, 0.515);
  EXPECT_DOUBLE_EQ(head_pitch_range(-0.756).min, -0.548);
  EXPECT_NEAR(head_pitch_range(0.243).max, 0.4685, 1e-6);
  EXPECT_DOUBLE_EQ(head_pitch_range(9.0).min, -0.449);
}

RC_GTEST_PROP(Head, ClampedIsWithinReachAndClampsNoFurther, ()) {
  const HeadAngles wanted{*rc::gen::inRange(-4000, 4000) * 1e-3, *rc::gen::inRange(-2000, 2000) * 1e-3};
  const HeadAngles reached = clamp_to_reach(wanted);
  const PitchRange range = head_pitch_range(reached.yaw);
  RC_ASSERT(std::abs(reached.yaw) <= kHeadYawLimit);
  RC_ASSERT(reached.pitch >= range.min);
  RC_ASSERT(reached.pitch <= range.max);
  const HeadAngles again = clamp_to_reach(reached);
  RC_ASSERT(again.yaw == reached.yaw && again.pitch == reached.pitch);
}

}  // namespace
}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "geometry/head.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

TEST(Head, OfAStandingRobotHasItsCameraAtHalfAMeter) {
  const RobotDimensions nao;
  const Isometry3 camera = robot_from_camera(nao, {}, {}, nao.torso_height);
  EXPECT_NEAR(camera.translation().z(), 0.523, 0.001);
  EXPECT_NEAR(camera.translation().x(), 0.0587, 0.001);
}

TEST(Head, WithYawToTheLeftLooksLeft) {
  const RobotDimensions nao;
  const Isometry3 camera = robot_from_camera(nao, {kPi / 2.0, 0.0}, {}, nao.torso_height);
  EXPECT_GT(camera.linear().col(0).y(), 0.99);
}

TEST(Head, PitchedForwardLooksDown) {
  const RobotDimensions nao;
  EXPECT_LT(robot_from_camera(nao, {0.0, 0.3}, {}, nao.torso_height).linear().col(0).z(), -0.29);
  EXPECT_LT(robot_from_camera(nao, {}, {0.0, 0.3}, nao.torso_height).linear().col(0).z(), -0.29);
}

TEST(Head, PitchRangeMatchesTheTableAndIsInterpolatedBetweenItsRows) {
  const NeckReach nao;
  EXPECT_DOUBLE_EQ(nao.pitch_at(0.0).max, 0.515);
  EXPECT_DOUBLE_EQ(nao.pitch_at(-0.756).min, -0.548);
  EXPECT_NEAR(nao.pitch_at(0.243).max, 0.4685, 1e-6);
  EXPECT_DOUBLE_EQ(nao.pitch_at(9.0).min, -0.449);
}

TEST(Head, OfANeckWithOneRangeHasThisRangeAtEveryYaw) {
  const NeckReach reach{1.0, {{0.0, -0.349, 0.855}}};
  for (const double yaw : {-2.0, -0.5, 0.0, 0.3, 1.0}) {
    EXPECT_EQ(reach.pitch_at(yaw).min, -0.349);
    EXPECT_EQ(reach.pitch_at(yaw).max, 0.855);
  }
  EXPECT_EQ(reach.clamp({-1.5, 1.0}).yaw, -1.0);
  EXPECT_EQ(reach.clamp({-1.5, 1.0}).pitch, 0.855);
}

TEST(Head, WithPitchBeforeYawLooksElsewhereWithTheSameAngles) {
  RobotDimensions robot;
  robot.second_axis = {0.0, 0.0, 0.1};
  const HeadAngles aside{0.5 * kPi, 0.5};
  const Isometry3 yaw_first = robot_from_camera(robot, aside, {}, robot.torso_height);
  robot.neck_order = NeckOrder::pitch_then_yaw;
  const Isometry3 pitch_first = robot_from_camera(robot, aside, {}, robot.torso_height);
  // With yaw first, the camera looks left and down; with pitch first, it looks left and level.
  EXPECT_LT(yaw_first.linear().col(0).z(), -0.4);
  EXPECT_NEAR(pitch_first.linear().col(0).z(), -robot.upper.tilt * std::cos(0.5), 0.01);
  EXPECT_NEAR(yaw_first.translation().x(), 0.0, 1e-9) << "the second axis is directly above the first one";
  EXPECT_GT(pitch_first.translation().x(), 0.04) << "the bent neck moves the second axis forward";
}

RC_GTEST_PROP(Head, ClampedIsWithinLimitsAndClampingAgainChangesNothing, ()) {
  const HeadAngles requested{*rc::gen::inRange(-4000, 4000) * 1e-3, *rc::gen::inRange(-2000, 2000) * 1e-3};
  const NeckReach nao;
  const HeadAngles reached = nao.clamp(requested);
  const PitchLimit range = nao.pitch_at(reached.yaw);
  RC_ASSERT(std::abs(reached.yaw) <= nao.yaw);
  RC_ASSERT(reached.pitch >= range.min);
  RC_ASSERT(reached.pitch <= range.max);
  const HeadAngles again = nao.clamp(reached);
  RC_ASSERT(again.yaw == reached.yaw && again.pitch == reached.pitch);
}

}  // namespace
}  // namespace reorient

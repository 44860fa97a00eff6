// SPDX-License-Identifier: MIT
// Walking, its speed and that of the head, as behaviors see them.
#include "engine/world/body_motion.h"

#include <gtest/gtest.h>

namespace reorient {
namespace {

constexpr double kFrame = 1.0 / 30.0;

BodyMotion walked(double speed, double turn, double seconds, BodyMotion motion = {}, double step = kFrame) {
  for (double time = 0.0; time < seconds - 1e-9; time += step)
    motion = after_step(motion, {speed * step, 0.0, turn * step}, step);
  return motion;
}

TEST(BodyMotion, FollowsTheOdometryAtEachFrameRate) {
  for (const double step : {1.0 / 120.0, 1.0 / 30.0, 1.0 / 5.0}) {
    const BodyMotion motion = walked(0.25, -0.5, 3.0, {}, step);
    EXPECT_NEAR(motion.speed, 0.25, 0.005) << step;
    EXPECT_NEAR(motion.measured.turn, -0.5, 0.01) << step;
    EXPECT_TRUE(is_walking(motion));
    EXPECT_FALSE(is_walking(walked(0.0, 0.0, 2.0, motion, step)));
  }
}

TEST(BodyMotion, ARequestCountsAsWalkingAtOnce) {
  EXPECT_FALSE(is_walking({}));
  EXPECT_TRUE(is_walking(after_request({}, {0.0, 0.1, 0.0})));
  EXPECT_TRUE(is_walking(after_request({}, {0.0, 0.0, -0.4})));
  EXPECT_DOUBLE_EQ(after_request({}, {0.3, 0.4, 0.0}).requested_speed, 0.5);
}

TEST(BodyMotion, ASwayingRobotStands) {
  BodyMotion motion;
  for (int i = 0; i < 300; ++i) motion = after_step(motion, {i % 2 == 0 ? 0.002 : -0.002, 0.0, 0.0}, kFrame);
  EXPECT_FALSE(is_walking(motion));
}

TEST(BodyMotion, TheHeadMovesWithItsFasterJoint) {
  BodyMotion motion;
  for (int i = 0; i < 30; ++i) motion = after_turn_of_head(motion, {0.0, -1.0 * kFrame}, kFrame);
  EXPECT_NEAR(motion.head_speed, 1.0, 0.01);
  EXPECT_TRUE(is_head_moving(motion));
  for (int i = 0; i < 30; ++i)
    motion = after_turn_of_head(motion, {0.0017 * (i % 2), 0.0}, kFrame);  // noise of a joint
  EXPECT_FALSE(is_head_moving(motion));
}

TEST(BodyMotion, AFrameWithoutTimeChangesNothing) {
  const BodyMotion motion = walked(0.2, 0.0, 1.0);
  EXPECT_DOUBLE_EQ(after_step(motion, {1.0, 0.0, 0.0}, 0.0).speed, motion.speed);
  EXPECT_DOUBLE_EQ(after_turn_of_head(motion, {1.0, 0.0}, 0.0).head_speed, motion.head_speed);
}

}  // namespace
}  // namespace reorient

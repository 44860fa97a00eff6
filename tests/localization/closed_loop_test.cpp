// SPDX-License-Identifier: MIT
// Whole runs of the pose filter with synthetic percepts and odometry.
#include <gtest/gtest.h>

#include "localization/pose_filter.h"
#include "tests/localization/synthetic_field.h"

namespace reorient {
namespace {

const Pose2 kMark(-3.2, 0.0, 0.0);
const Pose2 kBesideField(-3.2, -3.5, kPi / 2.0);

PoseFilter filter_at(const Pose2& pose, std::uint64_t seed) {
  PoseFilter filter(PoseFilterParameters(), FieldDimensions(), seed);
  filter.set_initial_pose(pose, 0.1, 0.05);
  return filter;
}

/// The goal in the center of the image, as room awareness would report it.
SeenGoal goal_ahead(const SyntheticRobot& robot) {
  return std::cos(robot.truth.rotation + scanning_yaw(robot.time)) > 0.0 ? SeenGoal::opponent : SeenGoal::own;
}

class ClosedLoop : public testing::TestWithParam<std::uint64_t> {};

TEST_P(ClosedLoop, TracksItsPoseWhileItWalksBetweenThePenaltyMarks) {
  PoseFilter filter = filter_at(kMark, GetParam());
  SyntheticRobot robot(filter, kMark, GetParam());
  double worst_position = 0.0;
  double worst_rotation = 0.0;
  while (robot.time < 120.0) {
    robot.walk();
    worst_position = std::max(worst_position, robot.position_error());
    worst_rotation = std::max(worst_rotation, robot.rotation_error());
  }
  EXPECT_LT(worst_position, 0.2);
  EXPECT_LT(worst_rotation, from_degrees(5.0));
}

TEST_P(ClosedLoop, TracksItsPoseBesideTheFieldWhileItMovesItsHead) {
  PoseFilter filter = filter_at(kBesideField, GetParam());
  SyntheticRobot robot(filter, kBesideField, GetParam());
  double worst_position = 0.0;
  while (robot.time < 60.0) {
    robot.stand();
    worst_position = std::max(worst_position, robot.position_error());
  }
  EXPECT_LT(worst_position, 0.25);
  EXPECT_LT(robot.position_error(), 0.1);
  EXPECT_LT(robot.rotation_error(), from_degrees(3.0));
}

TEST_P(ClosedLoop, CannotNoticeThatItStandsAtTheReflection) {
  PoseFilter filter = filter_at(reflect(kBesideField), GetParam());
  SyntheticRobot robot(filter, kBesideField, GetParam());
  while (robot.time < 60.0) {
    robot.stand();
    ASSERT_TRUE(robot.believes_reflection()) << robot.time;
  }
}

TEST_P(ClosedLoop, StaysAtTheReflectionWhileItWalks) {
  PoseFilter filter = filter_at(reflect(kMark), GetParam());
  SyntheticRobot robot(filter, kMark, GetParam());
  while (robot.time < 60.0) {
    robot.walk();
    ASSERT_TRUE(robot.believes_reflection()) << robot.time;
  }
}

TEST_P(ClosedLoop, IsCorrectImmediatelyAfterAFlip) {
  PoseFilter filter = filter_at(reflect(kBesideField), GetParam());
  SyntheticRobot robot(filter, kBesideField, GetParam());
  robot.stand_for(2.0);
  filter.flip_pose();
  EXPECT_TRUE(robot.believes_truth());
  robot.stand_for(5.0);
  EXPECT_TRUE(robot.believes_truth());
}

TEST_P(ClosedLoop, ReturnsFromTheReflectionWhenTheSeenGoalIsKnown) {
  PoseFilter filter = filter_at(reflect(kMark), GetParam());
  SyntheticRobot robot(filter, kMark, GetParam());
  while (robot.time < 180.0 && !robot.believes_truth()) robot.walk(goal_ahead(robot));
  EXPECT_TRUE(robot.believes_truth());
}

TEST_P(ClosedLoop, FindsItsRotationAgainAfterAReset) {
  const Pose2 start(-1.5, 1.0, 2.0);
  PoseFilter filter = filter_at(start, GetParam());
  SyntheticRobot robot(filter, start, GetParam());
  robot.stand_for(2.0);
  filter.reset_orientation();
  robot.stand_for(5.0);
  EXPECT_TRUE(robot.believes_truth() || robot.believes_reflection());
  EXPECT_GT(filter.belief().cluster_weight, 0.6);
}

TEST_P(ClosedLoop, FindsItsPoseAgainAfterItWasMovedTwoMetersSideways) {
  const Pose2 start(-1.5, 1.0, 0.0);
  PoseFilter filter = filter_at(start, GetParam());
  SyntheticRobot robot(filter, start, GetParam());
  robot.stand_for(3.0);
  robot.truth.position.y() -= 2.0;
  const double moved_at = robot.time;
  const auto found = [&] { return robot.believes_truth() || robot.believes_reflection(); };
  EXPECT_FALSE(found());
  while (robot.time < moved_at + 60.0 && !found()) robot.walk();
  EXPECT_TRUE(found());
}

TEST_P(ClosedLoop, FindsTheTruthFromAnywhereWhenTheSeenGoalIsKnown) {
  PoseFilter filter(PoseFilterParameters(), FieldDimensions(), GetParam());
  SyntheticRobot robot(filter, {-1.0, 1.0, 0.5}, GetParam());
  while (robot.time < 180.0 && !(robot.believes_truth() && filter.belief().cluster_weight > 0.6))
    robot.walk(goal_ahead(robot));
  EXPECT_TRUE(robot.believes_truth());
}

TEST_P(ClosedLoop, ToleratesErrorsTwoToFourTimesAsLarge) {
  PerceptErrors rough;
  rough.distance *= 2.0;
  rough.bearing *= 2.0;
  rough.sway *= 2.5;
  rough.false_points *= 4.0;
  PoseFilter filter = filter_at(kMark, GetParam());
  SyntheticRobot robot(filter, kMark, GetParam(), rough);
  while (robot.time < 60.0) {
    robot.walk();
    ASSERT_LT(robot.position_error(), 0.4) << robot.time;
  }
}

/// After the rotation nothing fits until new particles are drawn. The goal in view is unknown.
TEST(ClosedLoopOfMany, StayOnTheirSideWhenTheyArePlacedAgainSlightlyRotated) {
  const Pose2 beside_center(0.0, -3.0, kPi / 2.0);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    PoseFilter filter = filter_at(beside_center, seed);
    SyntheticRobot robot(filter, beside_center, seed);
    robot.stand_for(3.0 + 0.25 * static_cast<double>(seed));
    robot.truth.rotation -= from_degrees(14.0);
    robot.stand_for(5.0);
    EXPECT_TRUE(robot.believes_truth()) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ClosedLoop, testing::Values(1, 2, 3));

}  // namespace
}  // namespace reorient

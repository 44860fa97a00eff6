// SPDX-License-Identifier: MIT
// The robot that footage drives: its observations, its belief, and the effect of the engine's commands on the belief.
#include "robots/footage/footage_robot.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace reorient {
namespace {

/// Frames from a list; then the end, or an error.
class ListedFrames : public FootageSource {
 public:
  explicit ListedFrames(std::vector<FootageFrame> frames, std::string damage = "")
      : frames_(std::move(frames)), damage_(std::move(damage)) {}

  bool next(FootageFrame& frame) override {
    if (next_ < frames_.size()) {
      frame = frames_[next_++];
      return true;
    }
    if (!damage_.empty()) throw BadFootage(damage_);
    return false;
  }

 private:
  std::vector<FootageFrame> frames_;
  std::string damage_;
  std::size_t next_ = 0;
};

FootageFrame frame_at(double time, const Pose2& pose) {
  FootageFrame frame;
  frame.time = time;
  frame.image = Image(16, 8);
  frame.camera.width = 16;
  frame.camera.height = 8;
  frame.pose = pose;
  return frame;
}

/// Frames at intervals of 0.5 s, in each of which the robot has moved by 0.1 m.
std::vector<FootageFrame> walk(int frames) {
  std::vector<FootageFrame> all;
  all.reserve(static_cast<std::size_t>(frames));
  for (int i = 0; i < frames; ++i) all.push_back(frame_at(100.0 + 0.5 * i, Pose2(1.0 + 0.1 * i, 0.5, 0.2)));
  return all;
}

FootageRobot robot_of(std::vector<FootageFrame> frames, const FootageOptions& options = {}) {
  return FootageRobot(std::make_unique<ListedFrames>(std::move(frames)), options);
}

void expect_pose(const Pose2& found, const Pose2& expected) {
  EXPECT_LT((found.position - expected.position).norm(), 1e-9);
  EXPECT_LT(std::abs(angle_difference(found.rotation, expected.rotation)), 1e-9);
}

Answer answer_with(Reorientation reorientation) {
  Answer answer;
  answer.reorientation = reorientation;
  return answer;
}

TEST(FootageRobot, BelievesTheRecordedPoseAndBeginsAtTimeZero) {
  FootageRobot robot = robot_of(walk(3));
  Observation observation;
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(robot.observe(observation));
    EXPECT_DOUBLE_EQ(observation.time, 0.5 * i);
    ASSERT_TRUE(observation.upper);
    EXPECT_EQ(observation.upper->image.width, 16);
    expect_pose(observation.belief->pose, Pose2(1.0 + 0.1 * i, 0.5, 0.2));
    expect_pose(robot.truth()->pose, observation.belief->pose);
    EXPECT_FALSE(observation.external.initial_pose);
  }
  EXPECT_FALSE(robot.observe(observation));
  EXPECT_EQ(robot.failure(), "");
}

TEST(FootageRobot, UsesTheRequestedRate) {
  FootageOptions options;
  options.images_per_second = 10.0;
  FootageRobot robot = robot_of(walk(3), options);
  Observation observation;
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(robot.observe(observation));
    EXPECT_NEAR(observation.time, 0.1 * i, 1e-9);
  }
}

TEST(FootageRobot, ReceivesAMirroredInitialPoseAndCarriesOutAFlip) {
  FootageOptions options;
  options.change = BeliefChange{.at = 0.5, .mirrored = true};
  FootageRobot robot = robot_of(walk(4), options);
  Observation observation;
  ASSERT_TRUE(robot.observe(observation));
  EXPECT_FALSE(observation.external.initial_pose);
  ASSERT_TRUE(robot.observe(observation));
  ASSERT_TRUE(observation.external.initial_pose);
  expect_pose(observation.external.initial_pose->pose, reflect(Pose2(1.1, 0.5, 0.2)));
  expect_pose(observation.belief->pose, reflect(Pose2(1.1, 0.5, 0.2)));
  robot.answer(answer_with(Reorientation::flip_pose));
  ASSERT_TRUE(robot.observe(observation));
  EXPECT_FALSE(observation.external.initial_pose);
  expect_pose(observation.belief->pose, Pose2(1.2, 0.5, 0.2));
}

TEST(FootageRobot, AcceptsATimeThatWasRoundedToMicroseconds) {
  FootageOptions options;
  options.change = BeliefChange{.at = 0.5000004, .mirrored = true};
  FootageRobot robot = robot_of(walk(4), options);
  Observation observation;
  ASSERT_TRUE(robot.observe(observation));
  ASSERT_TRUE(robot.observe(observation));
  EXPECT_NEAR(observation.time, 0.5, 1e-9);
  EXPECT_TRUE(observation.external.initial_pose);
}

TEST(FootageRobot, ReceivesAnInitialPoseWithAWrongRotation) {
  FootageOptions options;
  options.change = BeliefChange{.at = 0.0, .turned_by = 0.3};
  FootageRobot robot = robot_of(walk(1), options);
  Observation observation;
  ASSERT_TRUE(robot.observe(observation));
  expect_pose(observation.belief->pose, Pose2(1.0, 0.5, 0.5));
}

TEST(FootageRobot, HasTwoHypothesesAfterAResetUntilAPurge) {
  FootageRobot robot = robot_of(walk(3));
  Observation observation;
  ASSERT_TRUE(robot.observe(observation));
  robot.answer(answer_with(Reorientation::reset_orientation));
  ASSERT_TRUE(robot.observe(observation));
  ASSERT_EQ(observation.belief->particles.size(), 2u);
  expect_pose(observation.belief->particles[1].pose, reflect(observation.belief->particles[0].pose));
  EXPECT_EQ(observation.belief->particles[0].weight, observation.belief->particles[1].weight);
  robot.answer(answer_with(Reorientation::purge_reflection));
  ASSERT_TRUE(robot.observe(observation));
  EXPECT_TRUE(observation.belief->particles.empty());
}

TEST(FootageRobot, HasNoImagesAndAnUnchangedBeliefWhileItIsLifted) {
  FootageOptions options;
  options.change = BeliefChange{.kind = BeliefChange::Kind::lifted, .at = 0.5, .mirrored = true, .lifted_for = 1.0};
  FootageRobot robot = robot_of(walk(5), options);
  Observation observation;
  const auto load = [&] { return observation.body.foot_load; };
  ASSERT_TRUE(robot.observe(observation));
  EXPECT_TRUE(observation.upper);
  EXPECT_GT(load(), 1.0);
  for (int i = 1; i < 3; ++i) {
    ASSERT_TRUE(robot.observe(observation));
    EXPECT_FALSE(observation.upper);
    EXPECT_EQ(load(), 0.0);
    EXPECT_TRUE(robot.truth()->carried);
    expect_pose(observation.belief->pose, robot.truth()->pose);
  }
  ASSERT_TRUE(robot.observe(observation));
  EXPECT_TRUE(observation.upper);
  EXPECT_GT(load(), 1.0);
  EXPECT_FALSE(observation.external.initial_pose);
  expect_pose(observation.belief->pose, reflect(robot.truth()->pose));
}

TEST(FootageRobot, StaysAtOnePositionIfOnlyItsRotationWasRecorded) {
  std::vector<FootageFrame> frames = walk(2);
  for (FootageFrame& frame : frames) {
    frame.heading = frame.pose->rotation + frame.time;
    frame.pose.reset();
  }
  FootageOptions options;
  options.start = Pose2(2.0, 1.0, 0.0);
  FootageRobot robot = robot_of(frames, options);
  EXPECT_TRUE(robot.truth());
  Observation observation;
  ASSERT_TRUE(robot.observe(observation));
  expect_pose(observation.belief->pose, Pose2(2.0, 1.0, 100.2));
  expect_pose(observation.odometry, Pose2(2.0, 1.0, 100.2));
}

TEST(FootageRobot, LeavesTheLocalizationToTheEngineIfNoPoseWasRecorded) {
  std::vector<FootageFrame> frames = walk(2);
  for (FootageFrame& frame : frames) frame.pose.reset();
  frames[1].odometry = Pose2(0.1, 0.0, 0.0);
  FootageOptions options;
  options.start = Pose2(2.0, 1.0, 0.5);
  FootageRobot robot = robot_of(frames, options);
  EXPECT_FALSE(robot.truth());
  Observation observation;
  ASSERT_TRUE(robot.observe(observation));
  EXPECT_FALSE(observation.belief);
  ASSERT_TRUE(observation.external.initial_pose);
  expect_pose(observation.external.initial_pose->pose, Pose2(2.0, 1.0, 0.5));
  ASSERT_TRUE(robot.observe(observation));
  EXPECT_FALSE(observation.external.initial_pose);
  expect_pose(observation.odometry, Pose2(0.1, 0.0, 0.0));
}

TEST(FootageRobot, HasGroundTruthOnlyInFramesWithAPose) {
  std::vector<FootageFrame> frames = walk(3);
  frames[1].pose.reset();
  FootageRobot robot = robot_of(frames, {});
  Observation observation;
  for (const bool is_known : {true, false, true}) {
    ASSERT_TRUE(robot.observe(observation));
    EXPECT_EQ(robot.truth().has_value(), is_known);
    EXPECT_EQ(observation.belief.has_value(), is_known);
  }
}

TEST(FootageRobot, EndsAtDamagedFootageAndReportsTheReason) {
  FootageRobot robot(std::make_unique<ListedFrames>(walk(1), "kitchen.mcap: it ends in the middle of a chunk"), {});
  Observation observation;
  EXPECT_TRUE(robot.observe(observation));
  EXPECT_FALSE(robot.observe(observation));
  EXPECT_FALSE(robot.observe(observation));
  EXPECT_EQ(robot.failure(), "kitchen.mcap: it ends in the middle of a chunk");
}

TEST(FootageRobot, RequiresAFrame) {
  EXPECT_THROW(robot_of({}), BadFootage);
  FootageOptions options;
  options.skipped = 2;
  EXPECT_THROW(robot_of(walk(2), options), BadFootage);
}

TEST(FootageRobot, KeepsTheTimesOfFramesAfterSkippedFrames) {
  FootageOptions options;
  options.skipped = 2;
  FootageRobot robot = robot_of(walk(4), options);
  Observation observation;
  ASSERT_TRUE(robot.observe(observation));
  EXPECT_DOUBLE_EQ(observation.time, 1.0);
  for (const BodySample& sample : observation.body_samples) EXPECT_GT(sample.time, 0.5);
}

}  // namespace
}  // namespace reorient

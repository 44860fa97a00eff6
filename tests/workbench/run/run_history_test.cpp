// SPDX-License-Identifier: MIT
// The bounded history of a run of any length.
#include "workbench/run/run_history.h"

#include <gtest/gtest.h>

namespace reorient {
namespace {

class History : public ::testing::Test {
 protected:
  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      frame.world.time = 0.1 * static_cast<double>(frame.world.frame++);
      history.observe(frame, scene);
    }
  }
  std::vector<ConditionInterval> intervals(RunCondition condition) const {
    std::vector<ConditionInterval> all;
    for (const ConditionInterval& interval : history.intervals()) {
      if (interval.condition == condition) all.push_back(interval);
    }
    return all;
  }

  FrameRecord frame;
  SceneTruth scene;
  RunHistory history;
};

TEST_F(History, StoresEveryPointOfAShortRun) {
  frame.world.confidence.current = 0.5;
  frames(100);
  ASSERT_EQ(history.points().size(), 100u);
  EXPECT_EQ(history.stride(), 1u);
  EXPECT_EQ(history.points()[7].current, 0.5);
  EXPECT_NEAR(history.points()[7].time, 0.7, 1e-9);
}

TEST_F(History, ThinsOldCurvesEvenly) {
  frames(100'000);
  EXPECT_LT(history.points().size(), RunHistory::kMostPoints);
  EXPECT_GE(history.points().size(), RunHistory::kMostPoints / 2);
  const double step = history.points()[1].time - history.points()[0].time;
  EXPECT_NEAR(step, 0.1 * static_cast<double>(history.stride()), 1e-9);
  for (std::size_t i = 1; i < history.points().size(); ++i)
    ASSERT_NEAR(history.points()[i].time - history.points()[i - 1].time, step, 1e-9) << i;
}

TEST_F(History, StoresIntervalsOfConditions) {
  frame.world.evaluating = true;
  frames(10);
  frame.world.posture = Posture::lifted;
  frames(5);
  frame.world.posture = Posture::upright;
  frames(10);
  ASSERT_EQ(intervals(RunCondition::lifted).size(), 1u);
  EXPECT_NEAR(intervals(RunCondition::lifted)[0].from, 1.0, 1e-9);
  EXPECT_NEAR(intervals(RunCondition::lifted)[0].to, 1.4, 1e-9);
  EXPECT_TRUE(intervals(RunCondition::evaluation_paused).empty());
}

TEST_F(History, JoinsIntervalsThatAPictureCannotSeparate) {
  for (int i = 0; i < 20'000; ++i) {
    frame.world.training = !frame.world.training;
    frames(1);
    ASSERT_LE(history.intervals().size(), RunHistory::kMostIntervals);
  }
  const auto training = intervals(RunCondition::training);
  ASSERT_FALSE(training.empty());
  EXPECT_EQ(training.front().from, 0.0);
  EXPECT_NEAR(training.back().to, 0.1 * 19'998, 0.11);
}

TEST_F(History, StoresTheFirstReorientationsAndTheLatestCommands) {
  frame.commands.push_back({{Reorientation::flip_pose, {}, 0.0}, Verdict::granted});
  frame.reorientation = ReorientationRecord{};
  frame.pose_particles.before = {Pose2(1.0, 2.0, 3.0)};
  frames(5000);
  EXPECT_EQ(history.reorientations().size(), RunHistory::kMostReorientations);
  EXPECT_EQ(history.reorientations_left_out(), 5000u - RunHistory::kMostReorientations);
  EXPECT_EQ(history.reorientations()[3].particles_before.size(), 1u);
  EXPECT_LE(history.commands().size(), RunHistory::kMostCommands);
  EXPECT_EQ(history.commands().size() + history.commands_left_out(), 5000u);
  EXPECT_NEAR(history.commands().back().time, 499.9, 1e-9);
}

}  // namespace
}  // namespace reorient

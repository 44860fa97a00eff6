// SPDX-License-Identifier: MIT
#include "workbench/run/run_summary.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

const Pose2 kTruth(2.0, 1.0, 0.3);

/// A run that gets only the belief.
struct Told {
  /// While the robot is at kTruth.
  void believe(const Pose2& belief, double from, double to, bool carried = false) {
    for (int i = 0; from + 0.1 * i < to - 1e-9; ++i) {
      FrameRecord frame;
      frame.world.time = from + 0.1 * i;
      frame.world.time_step = 0.1;
      frame.world.pose.pose = belief;
      frame.world.posture = carried ? Posture::lifted : Posture::upright;
      SceneTruth scene;
      scene.truth = GroundTruth{kTruth, false, carried};
      observer.observe(frame, scene);
    }
  }
  RunSummary summary() const { return observer.summary(); }

  SummaryObserver observer;
};

TEST(PoseError, IsComputedAcrossTheWrapOfAngles) {
  const PoseError error = pose_error(Pose2(3.0, 4.0, kPi - 0.1), Pose2(0.0, 0.0, -kPi + 0.1));
  EXPECT_DOUBLE_EQ(error.position, 5.0);
  EXPECT_NEAR(error.rotation, 0.2, 1e-12);
}

TEST(ARightBelief, IsWithinAMeterAndAnEighthTurnOfTheTruth) {
  EXPECT_TRUE(is_correct(kTruth, kTruth));
  EXPECT_TRUE(is_correct(Pose2(2.9, 1.0, 0.3), kTruth));
  EXPECT_FALSE(is_correct(Pose2(3.1, 1.0, 0.3), kTruth));
  EXPECT_TRUE(is_correct(Pose2(2.0, 1.0, 0.3 + 0.78), kTruth));
  EXPECT_FALSE(is_correct(Pose2(2.0, 1.0, 0.3 + 0.79), kTruth));
}

RC_GTEST_PROP(ARightBeliefProperty, IsNeverRightTogetherWithItsReflection, ()) {
  const auto any = [] { return *rc::gen::inRange(-5000, 5001) / 1000.0; };
  const Pose2 belief(any(), any(), any());
  const Pose2 truth(any(), any(), any());
  RC_ASSERT(!(is_correct(belief, truth) && is_correct(reflect(belief), truth)));
  RC_ASSERT(is_correct(belief, truth) == is_correct(reflect(belief), reflect(truth)));
}

TEST(Summary, WithoutFramesIsNotRight) {
  const RunSummary summary = SummaryObserver().summary();
  EXPECT_FALSE(summary.correct);
  EXPECT_FALSE(summary.succeeded);
  EXPECT_FALSE(summary.error);
  EXPECT_EQ(summary.frames, 0u);
  EXPECT_EQ(summary.verdict, "the scenario did not end in time");
}

TEST(Summary, RepeatsTheScenariosVerdict) {
  SummaryObserver observer;
  SceneTruth scene;
  scene.scenario.verdict = ScenarioVerdict{true, "it found its mark", 12.0};
  observer.observe(FrameRecord(), scene);
  EXPECT_TRUE(observer.summary().succeeded);
  EXPECT_EQ(observer.summary().verdict, "it found its mark");
}

TEST(Summary, OfABeliefThatWasNeverWrongHasNothingToCorrect) {
  Told run;
  run.believe(kTruth, 0.0, 10.0);
  const RunSummary summary = run.summary();
  EXPECT_TRUE(summary.correct);
  EXPECT_FALSE(summary.belief_wrong_at);
  EXPECT_FALSE(summary.corrected_after);
  EXPECT_EQ(summary.frames, 100u);
  EXPECT_NEAR(summary.seconds, 9.9, 1e-9);
  ASSERT_TRUE(summary.error);
  EXPECT_EQ(summary.error->position, 0.0);
}

TEST(Summary, ReportsHowLongItTookToCorrectTheBelief) {
  Told run;
  run.believe(kTruth, 0.0, 10.0);
  run.believe(reflect(kTruth), 10.0, 16.0);
  run.believe(kTruth, 16.0, 30.0);
  const RunSummary summary = run.summary();
  EXPECT_TRUE(summary.correct);
  ASSERT_TRUE(summary.corrected_after);
  EXPECT_NEAR(*summary.belief_wrong_at, 10.0, 1e-9);
  EXPECT_NEAR(*summary.corrected_after, 5.9, 0.11);
}

TEST(Summary, OfABeliefThatStayedWrongHasNoCorrection) {
  Told run;
  run.believe(kTruth, 0.0, 10.0);
  run.believe(reflect(kTruth), 10.0, 30.0);
  const RunSummary summary = run.summary();
  EXPECT_FALSE(summary.correct);
  EXPECT_NEAR(*summary.belief_wrong_at, 10.0, 1e-9);
  EXPECT_FALSE(summary.corrected_after);
  EXPECT_NEAR(summary.error->rotation, kPi, 1e-9);
}

TEST(Summary, CountsAShortRightBeliefAsPartOfTheWrongTime) {
  Told run;
  run.believe(kTruth, 0.0, 10.0);
  run.believe(reflect(kTruth), 10.0, 13.0);
  run.believe(kTruth, 13.0, 14.0);
  run.believe(reflect(kTruth), 14.0, 18.0);
  run.believe(kTruth, 18.0, 30.0);
  EXPECT_NEAR(*run.summary().belief_wrong_at, 10.0, 1e-9);
}

TEST(Summary, ReportsTheLastTimeThatTheBeliefWasWrong) {
  Told run;
  run.believe(reflect(kTruth), 0.0, 3.0);
  run.believe(kTruth, 3.0, 20.0);
  run.believe(reflect(kTruth), 20.0, 24.0);
  run.believe(kTruth, 24.0, 40.0);
  EXPECT_NEAR(*run.summary().belief_wrong_at, 20.0, 1e-9);
}

TEST(Summary, CountsThePeriodsOfWrongBeliefAndReportsTheLongest) {
  Told run;
  run.believe(kTruth, 0.0, 10.0);
  EXPECT_EQ(run.summary().wrong_periods, 0);
  EXPECT_EQ(run.summary().longest_wrong, 0.0);
  run.believe(reflect(kTruth), 10.0, 16.0);
  run.believe(kTruth, 16.0, 30.0);
  run.believe(reflect(kTruth), 30.0, 31.0);
  run.believe(kTruth, 31.0, 32.0);  // part of the same period
  run.believe(reflect(kTruth), 32.0, 33.0);
  run.believe(kTruth, 33.0, 50.0);
  const RunSummary summary = run.summary();
  EXPECT_EQ(summary.wrong_periods, 2);
  EXPECT_NEAR(summary.longest_wrong, 5.9, 0.11);
  EXPECT_NEAR(*summary.belief_wrong_at, 30.0, 1e-9);
  EXPECT_NEAR(*summary.corrected_after, 2.9, 0.11);
}

TEST(Summary, DoesNotJudgeTheBeliefWhileTheRobotIsCarried) {
  Told run;
  run.believe(kTruth, 0.0, 10.0);
  run.believe(reflect(kTruth), 10.0, 12.0, true);
  run.believe(kTruth, 12.0, 20.0);
  EXPECT_FALSE(run.summary().belief_wrong_at);
}

TEST(Summary, SumsTheTimeOfAWrongBelief) {
  Told run;
  run.believe(kTruth, 0.0, 10.0);
  run.believe(reflect(kTruth), 10.0, 13.0);
  run.believe(kTruth, 13.0, 30.0);
  run.believe(reflect(kTruth), 30.0, 31.0);
  EXPECT_NEAR(run.summary().wrong_seconds, 4.0, 1e-9);
}

TEST(Summary, DoesNotReportThatABeliefBecameWrongIfItWasNeverRight) {
  Told run;
  run.believe(reflect(kTruth), 0.0, 10.0);
  EXPECT_FALSE(run.summary().belief_wrong_at);
  EXPECT_EQ(run.summary().wrong_seconds, 0.0);
  run.believe(kTruth, 10.0, 20.0);
  EXPECT_FALSE(run.summary().belief_wrong_at);
  EXPECT_FALSE(run.summary().corrected_after);
}

TEST(Summary, ReportsThatTheOperatorMovedTheRobot) {
  Told run;
  run.believe(reflect(kTruth), 0.0, 1.0);
  run.believe(reflect(kTruth), 1.0, 2.0, true);
  run.believe(reflect(kTruth), 2.0, 3.0);
  EXPECT_DOUBLE_EQ(run.summary().belief_wrong_at.value(), 2.0);
}

TEST(Summary, ReportsHowARunEndedWithoutAVerdict) {
  EXPECT_EQ(SummaryObserver().summary(RunEnd::stopped).verdict, "interrupted");
  EXPECT_EQ(SummaryObserver().summary(RunEnd::robot_gone).verdict, "the robot sends no more frames");
}

TEST(Summary, NamesTheScriptsThatWereStopped) {
  SummaryObserver observer;
  FrameRecord frame;
  SceneTruth scene;
  const auto fails = [&](const char* script, int line, FaultRecord::Consequence consequence) {
    frame.faults.push_back({script, {script, line, "nil", {}}, consequence});
    observer.observe(frame, scene);
    frame.faults.clear();
  };
  fails("behaviors/a.lua", 1, FaultRecord::Consequence::none);
  fails("behaviors/a.lua", 2, FaultRecord::Consequence::stopped);
  fails("behaviors/b.lua", 3, FaultRecord::Consequence::stopped);
  fails("behaviors/c.lua", 4, FaultRecord::Consequence::rolled_back);
  frame.reloads.push_back({"behaviors/b.lua", true, {}, {}});
  observer.observe(frame, scene);
  const RunSummary summary = observer.summary();
  ASSERT_EQ(summary.stopped.size(), 1U);
  EXPECT_EQ(summary.stopped[0].script, "behaviors/a.lua");
  EXPECT_EQ(summary.stopped[0].errors, 2);
  EXPECT_EQ(summary.stopped[0].last, "behaviors/a.lua:2: nil");
}

TEST(Summary, WithoutGroundTruthIsNotJudged) {
  SummaryObserver observer;
  observer.observe(FrameRecord(), SceneTruth());
  const RunSummary summary = observer.summary();
  EXPECT_FALSE(summary.correct);
  EXPECT_FALSE(summary.error);
  EXPECT_EQ(summary.frames, 1u);
}

TEST(Summary, CountsAndJudgesTheReorientations) {
  SummaryObserver observer;
  for (const Reorientation reorientation :
       {Reorientation::flip_pose, Reorientation::purge_reflection, Reorientation::flip_pose,
        Reorientation::reset_orientation, Reorientation::flip_pose, Reorientation::purge_reflection}) {
    FrameRecord frame;
    frame.reorientation = ReorientationRecord{reorientation, {}, {}, {}};
    frame.reorientation->belief_before.pose = reflect(kTruth);
    frame.reorientation->belief_after.pose = kTruth;
    SceneTruth scene;
    scene.truth = GroundTruth{kTruth, false, false};
    observer.observe(frame, scene);
  }
  const RunSummary summary = observer.summary();
  EXPECT_EQ(summary.flips, 3);
  EXPECT_EQ(summary.purges, 2);
  EXPECT_EQ(summary.resets, 1);
  ASSERT_EQ(summary.reorientations.size(), 6u);
  EXPECT_EQ(summary.reorientations[1].reorientation, Reorientation::purge_reflection);
  EXPECT_EQ(summary.reorientations[1].correct_before, false);
  EXPECT_EQ(summary.reorientations[1].correct_after, true);
}

}  // namespace
}  // namespace reorient

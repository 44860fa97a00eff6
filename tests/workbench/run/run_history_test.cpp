#include "workbench/run/run_history.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

const Pose2 kTruth(2.0, 1.0, 0.3);

/// A second of frames: what is believed, while the robot is at kTruth.
void believe(RunHistory& history, const Pose2& belief, double from, double to, bool carried = false) {
  for (int i = 0; from + 0.1 * i < to - 1e-9; ++i) {
    FrameSample sample;
    sample.time = from + 0.1 * i;
    sample.belief.pose = belief;
    sample.truth = GroundTruth{kTruth, false, carried};
    sample.carried = carried;
    history.add(sample);
  }
}

void rearrange(RunHistory& history, Command command) {
  Rearrangement rearrangement;
  rearrangement.command = command;
  history.add(rearrangement);
}

TEST(PoseError, IsAcrossTheSeamOfTheAngles) {
  const PoseError error = pose_error(Pose2(3.0, 4.0, kPi - 0.1), Pose2(0.0, 0.0, -kPi + 0.1));
  EXPECT_DOUBLE_EQ(error.position, 5.0);
  EXPECT_NEAR(error.rotation, 0.2, 1e-12);
}

TEST(ARightBelief, IsWithinAMetreAndAnEighthTurnOfTheTruth) {
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

TEST(Summary, OfNothingIsNotRight) {
  const RunSummary summary = summarize({}, std::nullopt);
  EXPECT_FALSE(summary.correct);
  EXPECT_FALSE(summary.succeeded);
  EXPECT_FALSE(summary.error);
  EXPECT_EQ(summary.frames, 0);
  EXPECT_EQ(summary.verdict, "the scenario did not end in time");
}

TEST(Summary, RepeatsTheScenariosVerdict) {
  const RunSummary summary = summarize({}, ScenarioVerdict{true, "it found its mark", 12.0});
  EXPECT_TRUE(summary.succeeded);
  EXPECT_EQ(summary.verdict, "it found its mark");
}

TEST(Summary, OfABeliefThatWasNeverWrongHasNothingToCorrect) {
  RunHistory history;
  believe(history, kTruth, 0.0, 10.0);
  const RunSummary summary = summarize(history, std::nullopt);
  EXPECT_TRUE(summary.correct);
  EXPECT_FALSE(summary.belief_wrong_at);
  EXPECT_FALSE(summary.corrected_after);
  EXPECT_EQ(summary.frames, 100);
  EXPECT_NEAR(summary.seconds, 9.9, 1e-9);
  ASSERT_TRUE(summary.error);
  EXPECT_EQ(summary.error->position, 0.0);
}

TEST(Summary, SaysHowLongItTookToCorrectTheBelief) {
  RunHistory history;
  believe(history, kTruth, 0.0, 10.0);
  believe(history, reflect(kTruth), 10.0, 16.0);
  believe(history, kTruth, 16.0, 30.0);
  const RunSummary summary = summarize(history, std::nullopt);
  EXPECT_TRUE(summary.correct);
  ASSERT_TRUE(summary.corrected_after);
  EXPECT_NEAR(*summary.belief_wrong_at, 10.0, 1e-9);
  EXPECT_NEAR(*summary.corrected_after, 5.9, 0.11);
}

TEST(Summary, OfABeliefThatStayedWrongHasNoCorrection) {
  RunHistory history;
  believe(history, kTruth, 0.0, 10.0);
  believe(history, reflect(kTruth), 10.0, 30.0);
  const RunSummary summary = summarize(history, std::nullopt);
  EXPECT_FALSE(summary.correct);
  EXPECT_NEAR(*summary.belief_wrong_at, 10.0, 1e-9);
  EXPECT_FALSE(summary.corrected_after);
  EXPECT_NEAR(summary.error->rotation, kPi, 1e-9);
}

TEST(Summary, CountsAMomentOfRightBeliefToTheTimeThatItWasWrong) {
  RunHistory history;
  believe(history, kTruth, 0.0, 10.0);
  believe(history, reflect(kTruth), 10.0, 13.0);
  believe(history, kTruth, 13.0, 14.0);
  believe(history, reflect(kTruth), 14.0, 18.0);
  believe(history, kTruth, 18.0, 30.0);
  EXPECT_NEAR(*summarize(history, std::nullopt).belief_wrong_at, 10.0, 1e-9);
}

TEST(Summary, TellsOfTheLastTimeThatTheBeliefWasWrong) {
  RunHistory history;
  believe(history, reflect(kTruth), 0.0, 3.0);
  believe(history, kTruth, 3.0, 20.0);
  believe(history, reflect(kTruth), 20.0, 24.0);
  believe(history, kTruth, 24.0, 40.0);
  EXPECT_NEAR(*summarize(history, std::nullopt).belief_wrong_at, 20.0, 1e-9);
}

TEST(Summary, DoesNotBlameTheBeliefWhileTheRobotIsCarried) {
  RunHistory history;
  believe(history, kTruth, 0.0, 10.0);
  believe(history, reflect(kTruth), 10.0, 12.0, true);
  believe(history, kTruth, 12.0, 20.0);
  EXPECT_FALSE(summarize(history, std::nullopt).belief_wrong_at);
}

TEST(Summary, WithoutGroundTruthClaimsNothing) {
  RunHistory history;
  FrameSample sample;
  sample.time = 1.0;
  history.add(sample);
  const RunSummary summary = summarize(history, std::nullopt);
  EXPECT_FALSE(summary.correct);
  EXPECT_FALSE(summary.error);
  EXPECT_EQ(summary.frames, 1);
}

TEST(Summary, CountsTheReorientations) {
  RunHistory history;
  for (const Command command : {Command::flip_pose, Command::purge_reflection, Command::flip_pose,
                                Command::reset_orientation, Command::flip_pose, Command::purge_reflection}) {
    rearrange(history, command);
  }
  const RunSummary summary = summarize(history, std::nullopt);
  EXPECT_EQ(summary.flips, 3);
  EXPECT_EQ(summary.purges, 2);
  EXPECT_EQ(summary.resets, 1);
}

}  // namespace
}  // namespace reorient

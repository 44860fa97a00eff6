// SPDX-License-Identifier: MIT
// Measurements of a trial.
#include "workbench/experiments/trial/trial_observer.h"

#include <string>

#include <gtest/gtest.h>

namespace reorient {
namespace {

constexpr double kStep = 0.1;  // s
const Pose2 kTruth(2.0, 1.0, 0.3);

/// A trial that gets only the belief and the state of the scenario.
struct Told {
  explicit Told(const Measurement& measurement) : observer(measurement) {}

  FrameRecord frame(const Pose2& belief) {
    FrameRecord frame;
    frame.world.time = time += kStep;
    frame.world.time_step = kStep;
    frame.world.pose.pose = belief;
    return frame;
  }
  void show(const FrameRecord& frame, const std::string& state, bool carried = false) {
    Names names;
    SceneTruth scene;
    MachineStatus machine;
    machine.machine = names.intern("scene");
    machine.state = names.intern(state);
    scene.scenario.machines.push_back(machine);
    scene.scenario.names = names.table();
    scene.truth = GroundTruth{kTruth, false, carried};
    observer.observe(frame, scene);
  }
  void believe(const Pose2& belief, double seconds, const std::string& state = "lost", bool carried = false) {
    for (int i = 0; kStep * i < seconds - 1e-9; ++i) show(frame(belief), state, carried);
  }
  void reorient(Reorientation reorientation, const Pose2& before, const Pose2& after) {
    FrameRecord granted = frame(after);
    granted.reorientation.emplace();
    granted.reorientation->reorientation = reorientation;
    granted.reorientation->belief_before.pose = before;
    granted.reorientation->belief_after.pose = after;
    show(granted, "lost");
  }
  const TrialResult& result() const { return observer.result(); }

  TrialObserver observer;
  double time = 100.0;
};

Measurement from_lost() {
  Measurement measurement;
  measurement.from = "lost";
  measurement.limit = 20.0;
  return measurement;
}

TEST(Trial, IsMeasuredFromTheStateThatIsNamed) {
  Told trial(from_lost());
  trial.believe(reflect(kTruth), 5.0, "learning");
  EXPECT_FALSE(trial.result().started);
  trial.believe(reflect(kTruth), 3.0, "lost/searching");
  EXPECT_TRUE(trial.result().started);
  EXPECT_FALSE(trial.result().correct_at_start);
  EXPECT_NEAR(trial.result().seconds, 2.9, 1e-9);
  EXPECT_NEAR(trial.result().wrong_seconds, 2.9, 1e-9);
}

TEST(Trial, DistinguishesStatesWithTheSamePrefix) {
  Told trial(from_lost());
  trial.believe(kTruth, 1.0, "lost and found");
  EXPECT_FALSE(trial.result().started);
}

TEST(Trial, IsRightFromTheMomentAfterWhichItStaysRight) {
  Told trial(from_lost());
  trial.believe(reflect(kTruth), 4.1);
  trial.believe(kTruth, 3.0);
  trial.believe(reflect(kTruth), 1.0);
  trial.believe(kTruth, 9.9);
  EXPECT_TRUE(trial.result().failed());
  trial.believe(kTruth, 0.2);
  ASSERT_TRUE(trial.result().right_after);
  EXPECT_NEAR(*trial.result().right_after, 8.1, 1e-9);
  trial.believe(reflect(kTruth), 1.0);
  EXPECT_NEAR(*trial.result().right_after, 8.1, 1e-9) << "later events are in the other values";
}

TEST(Trial, FailsWhereTheBeliefIsRightTooLate) {
  Told trial(from_lost());
  trial.believe(reflect(kTruth), 20.3);
  trial.believe(kTruth, 15.0);
  EXPECT_TRUE(trial.result().failed());
  EXPECT_TRUE(trial.observer.is_over());
}

TEST(Trial, ThatIsRightAtTheLimitIsWatchedBeyondIt) {
  Told trial(from_lost());
  trial.believe(reflect(kTruth), 20.0);
  trial.believe(kTruth, 9.9);
  EXPECT_FALSE(trial.observer.is_over());
  trial.believe(kTruth, 0.3);
  EXPECT_TRUE(trial.observer.is_over());
  EXPECT_FALSE(trial.result().failed());
}

TEST(Trial, ThatWasNeverWrongIsRightAtOnce) {
  Told trial(from_lost());
  trial.believe(kTruth, 12.0);
  EXPECT_TRUE(trial.result().correct_at_start);
  ASSERT_TRUE(trial.result().right_after);
  EXPECT_NEAR(*trial.result().right_after, kStep, 1e-9);
  EXPECT_FALSE(trial.observer.is_over());
}

TEST(Trial, IsJudgedFromWhatTheScenarioDidOnNotBefore) {
  Told trial(from_lost());
  trial.believe(kTruth, 5.0, "learning");
  trial.show(trial.frame(kTruth), "lost");  // the scenario enters the state, and sets a wrong pose
  trial.believe(reflect(kTruth), 3.0);
  EXPECT_FALSE(trial.result().correct_at_start);
}

TEST(Trial, OfACarriedRobotIsJudgedOnceItStands) {
  Told trial(from_lost());
  trial.believe(kTruth, 5.0, "learning");
  trial.believe(kTruth, 2.0, "lost", true);
  trial.believe(kTruth, 1.0);
  EXPECT_TRUE(trial.result().correct_at_start);
}

TEST(Trial, ReportsWhenTheRoomDistinguishesThePoses) {
  Told trial(from_lost());
  trial.believe(kTruth, 2.0);
  EXPECT_FALSE(trial.result().usable_after);
  FrameRecord frame = trial.frame(kTruth);
  frame.world.room_status = RoomStatus::usable;
  trial.show(frame, "lost");
  trial.believe(kTruth, 2.0);
  ASSERT_TRUE(trial.result().usable_after);
  EXPECT_NEAR(*trial.result().usable_after, 2.0, 1e-9);
}

/// Carried from the truth to somewhere.
TrialResult carried_to(const Pose2& where) {
  Told trial(from_lost());
  SceneTruth scene;
  scene.truth = GroundTruth{kTruth, false, false};
  scene.scenario.actions.push_back({OperatorAction::Kind::pick_up, {}, 0.0, false});
  trial.observer.observe(trial.frame(kTruth), scene);
  scene.truth->carried = true;
  scene.scenario.actions = {{OperatorAction::Kind::put_down, where, 0.0, false}};
  trial.observer.observe(trial.frame(kTruth), scene);
  return trial.result();
}

TEST(Trial, KnowsAKidnappedRobotFromOneThatIsPutBack) {
  EXPECT_TRUE(carried_to(reflect(kTruth)).displaced);
  EXPECT_FALSE(carried_to(Pose2(kTruth.position.x() + 0.05, kTruth.position.y(), kTruth.rotation)).displaced);
}

TEST(Trial, InASymmetricRoomHasNotFailedIfTheRobotReportsSymmetry) {
  Measurement measurement = from_lost();
  measurement.symmetric_room = true;
  for (const RoomStatus status : {RoomStatus::usable, RoomStatus::symmetric}) {
    Told trial(measurement);
    trial.believe(reflect(kTruth), 2.0);
    FrameRecord frame = trial.frame(reflect(kTruth));
    frame.world.room_status = status;
    trial.show(frame, "lost");
    EXPECT_EQ(trial.result().failed(), status == RoomStatus::usable);
  }
}

TEST(Trial, MayEndOnceItIsRight) {
  Measurement measurement = from_lost();
  measurement.to_the_end = false;
  Told trial(measurement);
  trial.believe(kTruth, 10.0);
  EXPECT_FALSE(trial.observer.is_over());
  trial.believe(kTruth, 0.3);
  EXPECT_TRUE(trial.observer.is_over());
}

TEST(Trial, IsNotRightInTheAir) {
  Told trial(from_lost());
  trial.believe(kTruth, 5.0);
  trial.believe(kTruth, 1.0, "lost", true);
  trial.believe(kTruth, 12.0);
  ASSERT_TRUE(trial.result().right_after);
  EXPECT_NEAR(*trial.result().right_after, 6.0, 1e-9);
  EXPECT_NEAR(trial.result().right_seconds, 16.9, 1e-9);
}

TEST(Trial, ReportsTheCommandThatCorrectedTheBelief) {
  Told trial(from_lost());
  trial.believe(reflect(kTruth), 3.0);
  trial.reorient(Reorientation::purge_reflection, reflect(kTruth), reflect(kTruth));
  trial.believe(reflect(kTruth), 1.0);
  trial.reorient(Reorientation::flip_pose, reflect(kTruth), kTruth);
  trial.reorient(Reorientation::flip_pose, kTruth, reflect(kTruth));
  trial.reorient(Reorientation::flip_pose, reflect(kTruth), kTruth);
  const TrialResult& result = trial.result();
  ASSERT_TRUE(result.corrected_after);
  EXPECT_NEAR(*result.corrected_after, 4.1, 1e-9);
  EXPECT_EQ(result.corrected_by, Reorientation::flip_pose);
  EXPECT_EQ(result.flips, 3);
  EXPECT_EQ(result.false_flips, 1);
  EXPECT_EQ(result.purges, 1);
  EXPECT_EQ(result.false_purges, 0);
}

TEST(Trial, KeepsTheConfidencesTwiceASecond) {
  Told trial(from_lost());
  trial.believe(kTruth, 10.1);
  ASSERT_EQ(trial.result().confidences.size(), 20U);
  EXPECT_NEAR(trial.result().confidences[1].time - trial.result().confidences[0].time, 0.5, 1e-9);
  EXPECT_TRUE(trial.result().confidences[0].correct);
}

TEST(Trial, WithoutAStateIsMeasuredFromTheFirstFrame) {
  Told trial(Measurement{});
  trial.believe(kTruth, 1.0, "anything");
  EXPECT_TRUE(trial.result().started);
}

}  // namespace
}  // namespace reorient

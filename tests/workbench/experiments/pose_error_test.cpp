// SPDX-License-Identifier: MIT
// Errors of the belief of a trial, and their statistics in a row.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "workbench/experiments/tables/pose_row.h"
#include "workbench/experiments/trial/pose_error_observer.h"

namespace reorient {
namespace {

constexpr double kTenth = 0.1;  // s, of a frame
const Pose2 kPlace(1.0, 2.0, 0.5);

Measurement measured_for_long() {
  Measurement measurement;
  measurement.limit = 1000.0;
  return measurement;
}

/// A trial whose clock starts with the first frame.
struct Compared {
  Compared() : trial(measured_for_long()), observer(trial) {}

  void believe(const Pose2& belief, double seconds, bool fallen = false, bool carried = false) {
    for (int i = 0; kTenth * i < seconds - 1e-9; ++i) {
      FrameRecord frame;
      frame.world.time = time += kTenth;
      frame.world.time_step = kTenth;
      frame.world.pose.pose = belief;
      frame.world.pose.covariance.diagonal() << 0.01, 0.01, 0.0025;
      SceneTruth scene;
      scene.truth = GroundTruth{kPlace, fallen, carried};
      trial.observe(frame, scene);
      observer.observe(frame, scene);
    }
  }
  PoseRow row() const {
    TrialResult result = trial.result();
    result.pose_errors = observer.errors();
    return pose_row_of({result}).value();
  }

  TrialObserver trial;
  PoseErrorObserver observer;
  double time = 0.0;
};

Pose2 off_by(double meters, double radians) {
  return {kPlace.position.x() + meters, kPlace.position.y(), kPlace.rotation + radians};
}

TEST(PoseErrors, AreRootMeanSquaresOverFrames) {
  Compared compared;
  compared.believe(kPlace, 0.1);  // starts the clock
  compared.believe(off_by(0.1, 0.0), 2.0);
  compared.believe(off_by(0.0, 0.1), 2.0);
  const PoseRow row = compared.row();
  EXPECT_NEAR(row.position, 0.1 / std::numbers::sqrt2, 1e-3);
  EXPECT_NEAR(row.rotation, 0.1 / std::numbers::sqrt2, 1e-3);
  // Squares of 1 and of 4 in turn, over three degrees of freedom.
  EXPECT_NEAR(row.normalized, (1.0 + 4.0) / 2.0 / 3.0, 0.05);
  EXPECT_EQ(row.within, 1.0);
  EXPECT_EQ(row.mirrored, 0.0);
}

TEST(PoseErrors, OfAMirroredBeliefAreThoseOfItsReflection) {
  Compared compared;
  compared.believe(kPlace, 0.1);
  compared.believe(reflect(off_by(0.1, 0.0)), 4.0);
  const PoseRow row = compared.row();
  EXPECT_NEAR(row.position, 0.1, 5e-3);
  EXPECT_NEAR(row.mirrored, 1.0, 0.05);
}

TEST(PoseErrors, CountHowOftenTheStatedDeviationIsTooSmall) {
  Compared compared;
  compared.believe(kPlace, 0.1);
  compared.believe(off_by(0.5, 0.0), 1.0);
  compared.believe(off_by(0.05, 0.0), 3.0);
  EXPECT_NEAR(compared.row().within, 0.75, 0.02);
}

TEST(PoseErrors, LeaveOutFallsAndTheFirstSecondsAfterThem) {
  Compared compared;
  compared.believe(kPlace, 10.0);
  compared.believe(off_by(3.0, 1.0), 3.0, true);
  compared.believe(off_by(3.0, 1.0), 4.0);
  compared.believe(kPlace, 4.0);
  const PoseRow row = compared.row();
  EXPECT_NEAR(row.position, 0.0, 1e-9);
  EXPECT_EQ(row.falls, 1);
  EXPECT_NEAR(*row.right_p90, 4.0, 0.15);
  EXPECT_NEAR(*row.located_p90, 4.0, 0.15);
}

TEST(PoseErrors, ReportAFallAfterWhichOnlyTheMirroredPoseIsFound) {
  Compared compared;
  compared.believe(kPlace, 1.0);
  compared.believe(kPlace, 3.0, true);
  compared.believe(off_by(2.0, 0.0), 1.0);
  compared.believe(reflect(kPlace), 10.0);
  const PoseRow row = compared.row();
  EXPECT_FALSE(row.right_p90);
  EXPECT_NEAR(*row.located_p90, 1.0, 0.15);
}

TEST(PoseErrors, ReportWhenThePoseOrTheMirroredPoseIsFirstFound) {
  Compared compared;
  compared.believe(off_by(2.0, 0.0), 4.0);
  compared.believe(reflect(kPlace), 1.0);  // not for long enough
  compared.believe(off_by(2.0, 0.0), 1.0);
  compared.believe(reflect(kPlace), 5.0);
  const PoseRow row = compared.row();
  EXPECT_NEAR(*row.first_located_p90, 5.9, 0.15);
  EXPECT_EQ(row.located_in_time, 1);
}

TEST(PoseErrors, CountNothingInTheAir) {
  Compared compared;
  compared.believe(kPlace, 0.1, false, true);
  compared.believe(off_by(2.0, 0.0), 5.0, false, true);
  EXPECT_EQ(compared.observer.errors().frames, 0);
}

TEST(PoseErrors, AreMissingIfNoTrialMeasuredThem) { EXPECT_FALSE(pose_row_of({TrialResult()})); }

}  // namespace
}  // namespace reorient

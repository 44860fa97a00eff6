// SPDX-License-Identifier: MIT
// Statistics of the trials of a cell.
#include "workbench/experiments/tables/row.h"

#include <cmath>

#include <gtest/gtest.h>

#include "workbench/experiments/tables/cell_results.h"

namespace reorient {
namespace {

TrialResult corrected(double right_after, Reorientation by = Reorientation::flip_pose, double corrected_after = 2.0) {
  TrialResult result;
  result.started = true;
  result.seconds = 70.0;
  result.correct_at_start = false;
  result.right_after = right_after;
  result.corrected_after = corrected_after;
  result.corrected_by = by;
  result.flips = by == Reorientation::flip_pose ? 1 : 0;
  result.purges = 1 - result.flips;
  return result;
}
TrialResult failed() {
  TrialResult result;
  result.started = true;
  result.seconds = 70.0;
  result.correct_at_start = false;
  return result;
}
TrialResult stays_correct(double right_seconds, int false_flips) {
  TrialResult result;
  result.started = true;
  result.right_after = 0.1;
  result.right_seconds = right_seconds;
  result.flips = result.false_flips = false_flips;
  return result;
}

TEST(Row, CountsFailuresOfDisturbedTrials) {
  const Row row = row_of({corrected(3.0), failed(), stays_correct(100.0, 0), TrialResult()});
  EXPECT_EQ(row.trials, 4);
  EXPECT_EQ(row.disturbed, 3);
  EXPECT_EQ(row.failed, 2) << "one never started";
  EXPECT_EQ(row.not_started, 1);
  EXPECT_LT(row.failed_rate.low, 2.0 / 3.0);
  EXPECT_GT(row.failed_rate.high, 2.0 / 3.0);
}

TEST(Row, ReportsKidnappedTrialsSeparately) {
  TrialResult carried = corrected(4.0);
  TrialResult lost = failed();
  carried.displaced = lost.displaced = true;
  const Row row = row_of({carried, lost, corrected(8.0), stays_correct(10.0, 0)});
  EXPECT_EQ(row.displaced, 2);
  EXPECT_EQ(row.displaced_failed, 1);
  EXPECT_EQ(row.displaced_right.mean, 4.0);
}

TEST(Row, CountsATrialWithoutACommandAsLaterThanAllOthers) {
  const Row row =
      row_of({corrected(3.0, Reorientation::flip_pose, 1.0), corrected(3.0, Reorientation::flip_pose, 2.0), failed()});
  EXPECT_EQ(row.command_median, 2.0);
  EXPECT_FALSE(row.command_p90);
}

TEST(Row, ReportsTheTimesOfTrialsThatDidNotFail) {
  const Row row = row_of({corrected(3.0), corrected(5.0), failed()});
  EXPECT_EQ(row.right.mean, 4.0);
  EXPECT_EQ(row.by_command.mean, 2.0);
  ASSERT_TRUE(row.right.interval);
  EXPECT_GE(row.right.interval->low, 3.0);
  const Row one = row_of({corrected(3.0), failed()});
  EXPECT_EQ(one.right.mean, 3.0);
  EXPECT_FALSE(one.right.interval) << "one trial shows nothing of the spread";
}

TEST(Row, CountsAFailedTrialAsLaterThanAllOthersInItsQuantiles) {
  const Row row = row_of({corrected(3.0), corrected(5.0), failed()});
  EXPECT_EQ(row.right_median, 5.0);
  EXPECT_FALSE(row.right_p90) << "a third of the trials was never right";
}

TEST(Row, DistinguishesFlipsFromPurges) {
  const Row row = row_of({corrected(3.0, Reorientation::flip_pose, 1.0), corrected(3.0, Reorientation::flip_pose, 2.0),
                          corrected(9.0, Reorientation::purge_reflection, 6.0)});
  EXPECT_EQ(row.flip, 2);
  EXPECT_EQ(row.purge, 1);
  EXPECT_EQ(row.flip_time.mean, 1.5);
  EXPECT_EQ(row.purge_time.mean, 6.0);
  EXPECT_EQ(row.by_command.mean, 3.0);
}

TEST(Row, CountsFalseFlipsPerHourOfRightBelief) {
  const Row row = row_of({stays_correct(1800.0, 0), stays_correct(1800.0, 5)});
  EXPECT_EQ(row.disturbed, 0);
  EXPECT_EQ(row.right_hours, 1.0);
  EXPECT_EQ(row.false_flips, 5);
  EXPECT_NEAR(row.false_flip_rate.low, 1.623, 1e-3);
  EXPECT_NEAR(row.false_flip_rate.high, 11.668, 1e-3);
}

TEST(Row, UsesTheEvidenceOnlyIfItIsUsableAndOneOfTheTwoPosesIsRight) {
  TrialResult trial = corrected(3.0);
  const double sure = std::log(9.0);
  trial.confidences = {{0.5, 0.0, 0.0, sure, RoomStatus::usable, false, true},    // right: the reflection it was
                       {1.0, 0.0, 0.0, -sure, RoomStatus::usable, true, false},   // right
                       {1.5, 0.0, 0.0, sure, RoomStatus::usable, true, false},    // wrong
                       {2.0, 0.0, 0.0, sure, RoomStatus::usable, false, false},   // the robot is elsewhere
                       {2.5, 0.0, 0.0, sure, RoomStatus::resting, true, false}};  // not used
  const Row row = row_of({trial});
  EXPECT_EQ(row.calibration_samples, 3);
  ASSERT_TRUE(row.calibration_error);
  EXPECT_NEAR(*row.calibration_error, 0.9 - 2.0 / 3.0, 1e-9);
}

TEST(Row, ReportsTheFractionOfTimeInWhichTheRoomWasCalledSymmetric) {
  TrialResult trial = stays_correct(30.0, 0);
  trial.wrong_seconds = 10.0;
  trial.uninformative_seconds = 10.0;
  EXPECT_EQ(row_of({trial}).uninformative_time, 0.25);
  EXPECT_FALSE(row_of({TrialResult{}}).uninformative_time);
}

TEST(Row, ReportsHowWellTheConfidencesSeparateWrongBeliefsFromRightOnes) {
  TrialResult trial = stays_correct(10.0, 0);
  EXPECT_FALSE(row_of({trial}).confidence_area);
  const auto seen = [&trial](double current, double opposite, bool correct, RoomStatus status) {
    trial.confidences.push_back({0.0, current, opposite, 0.0, status, correct, !correct});
  };
  seen(0.9, 0.0, true, RoomStatus::usable);
  seen(0.3, 0.3, true, RoomStatus::fresh);
  EXPECT_FALSE(row_of({trial}).confidence_area) << "it was never wrong";
  seen(0.1, 0.8, false, RoomStatus::usable);
  EXPECT_EQ(row_of({trial}).confidence_area, 1.0);
  seen(0.5, 0.1, false, RoomStatus::usable);
  EXPECT_EQ(row_of({trial}).confidence_area, 0.75);
  seen(0.0, 0.0, false, RoomStatus::off);
  EXPECT_EQ(row_of({trial}).confidence_area, 0.75) << "no look";
}

TEST(Row, WithoutTrialsHasNoValues) {
  const Row row = row_of({});
  EXPECT_FALSE(row.calibration_error);
  EXPECT_FALSE(row.uninformative_time);
  EXPECT_EQ(row.trials, 0);
  EXPECT_FALSE(row.right.mean);
  EXPECT_EQ(row.failed_rate.high, 1.0);
  EXPECT_TRUE(std::isinf(row.false_flip_rate.high));
}

CellResults cell(std::vector<std::string> choices, const std::vector<TrialResult>& trials) {
  return {std::move(choices), trials, row_of(trials)};
}

Experiment of_axes(const std::vector<std::string>& names) {
  Experiment experiment;
  for (const std::string& name : names) experiment.axes.emplace_back().name = name;
  return experiment;
}

TEST(RowsOfAllRooms, CountTheTrialsOfEachChoiceTogether) {
  const std::vector<CellResults> pooled = pooled_over_rooms(
      of_axes({"room", "motion"}),
      {cell({"hall", "head"}, {corrected(1.0), failed()}), cell({"hall", "walk"}, {corrected(5.0)}),
       cell({"lab", "head"}, {corrected(3.0), stays_correct(3600.0, 1)}), cell({"lab", "walk"}, {corrected(7.0)})});
  ASSERT_EQ(pooled.size(), 2u);
  EXPECT_EQ(pooled[0].choices, (std::vector<std::string>{"all", "head"}));
  EXPECT_EQ(pooled[0].row.trials, 4);
  EXPECT_EQ(pooled[0].row.disturbed, 3);
  EXPECT_EQ(pooled[0].row.failed, 1);
  EXPECT_EQ(pooled[0].row.right.mean, 2.0);
  EXPECT_EQ(pooled[0].row.false_flips, 1);
  EXPECT_EQ(pooled[0].row.right_hours, 1.0);
  EXPECT_TRUE(pooled[0].trials.empty());
  EXPECT_EQ(pooled[1].choices, (std::vector<std::string>{"all", "walk"}));
  EXPECT_EQ(pooled[1].row.right.mean, 6.0);
}

TEST(RowsOfAllRooms, AreMissingForASingleRoom) {
  const std::vector<CellResults> one_room = {cell({"head", "hall"}, {failed()}), cell({"walk", "hall"}, {failed()})};
  EXPECT_TRUE(pooled_over_rooms(of_axes({"motion", "room"}), one_room).empty());
  EXPECT_TRUE(pooled_over_rooms(of_axes({"motion", "light"}), one_room).empty());
  EXPECT_TRUE(pooled_over_rooms(of_axes({"room"}), {}).empty());
}

}  // namespace
}  // namespace reorient

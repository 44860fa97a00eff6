// SPDX-License-Identifier: MIT
#include "workbench/experiments/tables/row.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "workbench/experiments/statistics/rates.h"
#include "workbench/experiments/statistics/roc.h"

namespace reorient {
namespace {

TimeRow time_row(const std::vector<double>& times) {
  if (times.empty()) return {};
  if (times.size() == 1) return {times.front(), std::nullopt};  // one trial shows nothing of the spread
  return {mean(times), bootstrap_interval(times)};
}

std::optional<double> if_known(double value) { return std::isnan(value) ? std::nullopt : std::optional(value); }

}  // namespace

Row row_of(const std::vector<TrialResult>& results) {
  Row row;
  std::vector<double> right, by_command, by_flip, by_purge, displaced_right, usable;
  std::vector<CensoredTime> until_corrected;
  double right_seconds = 0.0, standing_seconds = 0.0, uninformative_seconds = 0.0;
  for (const TrialResult& result : results) {
    ++row.trials;
    row.not_started += result.started ? 0 : 1;
    row.flips += result.flips;
    row.purges += result.purges;
    row.false_flips += result.false_flips;
    row.false_purges += result.false_purges;
    right_seconds += result.right_seconds;
    standing_seconds += result.right_seconds + result.wrong_seconds;
    uninformative_seconds += result.uninformative_seconds;
    if (result.usable_after) usable.push_back(*result.usable_after);
    if (result.displaced) {
      ++row.displaced;
      row.displaced_failed += result.failed() ? 1 : 0;
      if (result.right_after) displaced_right.push_back(*result.right_after);
    }
    if (!result.disturbed()) continue;
    ++row.disturbed;
    row.failed += result.failed() ? 1 : 0;
    row.uninformative += result.failed() && result.ended_uninformative ? 1 : 0;
    until_corrected.push_back({result.corrected_after.value_or(result.seconds), result.corrected_after.has_value()});
    if (result.right_after) right.push_back(*result.right_after);
    if (!result.corrected_after) continue;
    by_command.push_back(*result.corrected_after);
    row.flip += result.corrected_by == Reorientation::flip_pose ? 1 : 0;
    row.purge += result.corrected_by == Reorientation::purge_reflection ? 1 : 0;
    row.reset += result.corrected_by == Reorientation::reset_orientation ? 1 : 0;
    if (result.corrected_by == Reorientation::flip_pose) by_flip.push_back(*result.corrected_after);
    if (result.corrected_by == Reorientation::purge_reflection) by_purge.push_back(*result.corrected_after);
  }
  constexpr double kHour = 3600.0;  // s
  row.failed_rate = wilson_interval(row.failed, row.disturbed);
  row.right = time_row(right);
  const std::vector<SurvivalStep> curve = kaplan_meier(times_until_right(results));
  row.right_median = if_known(time_by_which(curve, 0.5));
  row.right_p90 = if_known(time_by_which(curve, 0.9));
  row.by_command = time_row(by_command);
  const std::vector<SurvivalStep> by_command_curve = kaplan_meier(until_corrected);
  row.command_median = if_known(time_by_which(by_command_curve, 0.5));
  row.command_p90 = if_known(time_by_which(by_command_curve, 0.9));
  row.displaced_right = time_row(displaced_right);
  row.usable = time_row(usable);
  row.flip_time = time_row(by_flip);
  row.purge_time = time_row(by_purge);
  row.right_hours = right_seconds / kHour;
  row.false_flip_rate = poisson_rate(row.false_flips, row.right_hours);
  // The robot measures a fall a little later than it happens.
  if (standing_seconds > 0.0) row.uninformative_time = std::min(uninformative_seconds / standing_seconds, 1.0);
  const std::vector<CalibrationBin> bins = calibration_of(results);
  for (const CalibrationBin& bin : bins) row.calibration_samples += bin.samples;
  if (row.calibration_samples > 0) row.calibration_error = calibration_error(bins);
  ScoredSamples samples;
  add_scores(samples, results);
  row.pose = pose_row_of(results);
  row.measures = measure_rows_of(results);
  row.confidence_area = if_known(area_below(roc_curve(std::move(samples.wrong), std::move(samples.right))));
  return row;
}

std::vector<CalibrationBin> calibration_of(const std::vector<TrialResult>& results) {
  std::vector<double> for_the_truth;
  for (const TrialResult& result : results) {
    for (const ConfidenceSample& sample : result.confidences) {
      if (sample.status != RoomStatus::usable || sample.correct == sample.reflected) continue;
      for_the_truth.push_back(sample.correct ? -sample.evidence : sample.evidence);
    }
  }
  return calibration_bins(for_the_truth);
}

void add_scores(ScoredSamples& samples, const std::vector<TrialResult>& results) {
  for (const TrialResult& result : results) {
    for (const ConfidenceSample& sample : result.confidences) {
      if (sample.status != RoomStatus::off)
        (sample.correct ? samples.right : samples.wrong).push_back(sample.opposite - sample.current);
    }
  }
}

std::vector<CensoredTime> times_until_right(const std::vector<TrialResult>& results) {
  std::vector<CensoredTime> times;
  for (const TrialResult& result : results) {
    if (result.disturbed())
      times.push_back({result.right_after.value_or(result.seconds), result.right_after.has_value()});
  }
  return times;
}

}  // namespace reorient

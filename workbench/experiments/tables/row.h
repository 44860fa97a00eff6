// SPDX-License-Identifier: MIT
// Statistics of the trials of one cell.
#pragma once

#include <optional>
#include <vector>

#include "workbench/experiments/statistics/calibration.h"
#include "workbench/experiments/statistics/interval.h"
#include "workbench/experiments/statistics/times.h"
#include "workbench/experiments/tables/measure_row.h"
#include "workbench/experiments/tables/pose_row.h"
#include "workbench/experiments/trial/trial_result.h"

namespace reorient {

/// Statistics of times, in s; nothing without times.
struct TimeRow {
  std::optional<double> mean;
  std::optional<Interval> interval;  ///< of the mean, by bootstrap; empty with fewer than two trials
};

/// Trials whose belief was wrong when their clock started show how it is corrected; the others show whether a right
/// belief stays right.
struct Row {
  int trials = 0;
  int not_started = 0;  ///< that never reached the state from which they are measured: they failed, too
  int disturbed = 0;    ///< trials that started with a wrong belief, or never started
  int failed = 0;       ///< of the disturbed
  Interval failed_rate;
  TimeRow right;                       ///< time until the belief is right and stays right, of trials that did not fail
  std::optional<double> right_median;  ///< failed trials count as later than all others; nothing: too many failed
  std::optional<double> right_p90;
  int flip = 0;   ///< disturbed trials whose belief was first corrected by a flip
  int purge = 0;  ///< the same by a purge
  int reset = 0;
  TimeRow by_command;                    ///< time until the command that corrects the belief: the paper's measure
  std::optional<double> command_median;  ///< trials without one count as later than all others
  std::optional<double> command_p90;
  TimeRow flip_time;
  TimeRow purge_time;
  int flips = 0;  ///< commands in all trials
  int purges = 0;
  int false_flips = 0;
  int false_purges = 0;
  double right_hours = 0.0;  ///< for which the belief was right
  Interval false_flip_rate;  ///< per right hour; 0 to infinity without right hours
  int displaced = 0;         ///< trials whose robot was moved to another place while lifted
  int displaced_failed = 0;  ///< of those
  TimeRow displaced_right;   ///< as `right`, of those
  TimeRow usable;            ///< time until the room distinguished the two poses, of the trials in which it did
  int uninformative = 0;     ///< failed trials in which the robot called its room symmetric at the end
  /// Fraction of the time on its feet in which the robot called its room symmetric; nothing: it never stood.
  std::optional<double> uninformative_time;
  int calibration_samples = 0;              ///< of the evidence while the belief was right, or the reflection
  std::optional<double> calibration_error;  ///< of those; nothing without samples
  std::optional<PoseRow> pose;
  std::vector<MeasureRow> measures;  ///< in the order of the experiment's measures
  std::optional<double>
      confidence_area;  ///< below the ROC curve of the confidences' lead; nothing: only right or only wrong beliefs
};

Row row_of(const std::vector<TrialResult>& results);

/// The evidence while it was used and the belief was right or mirrored.
std::vector<CalibrationBin> calibration_of(const std::vector<TrialResult>& results);

/// The confidences' lead, opposite minus current, whenever the room was evaluated.
struct ScoredSamples {
  std::vector<double> wrong, right;  ///< while the belief was wrong or right
};
void add_scores(ScoredSamples& samples, const std::vector<TrialResult>& results);

/// Times until the belief is right and stays right, of the disturbed trials.
std::vector<CensoredTime> times_until_right(const std::vector<TrialResult>& results);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// The measures of an experiment, over the trials of one cell.
#pragma once

#include <optional>
#include <vector>

#include "workbench/experiments/statistics/interval.h"
#include "workbench/experiments/trial/trial_result.h"

namespace reorient {

/// One measure over the trials that have a value of it.
struct MeasureRow {
  int trials = 0;
  double mean = 0.0;
  std::optional<Interval> interval;  ///< of the mean, by bootstrap; empty with fewer than two trials
  double least = 0.0, most = 0.0;
};

/// In the order of the measures.
std::vector<MeasureRow> measure_rows_of(const std::vector<TrialResult>& results);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Accuracy of the belief in the trials of one cell.
#pragma once

#include <optional>
#include <vector>

#include "workbench/experiments/statistics/interval.h"
#include "workbench/experiments/trial/trial_result.h"

namespace reorient {

/// Errors relative to the true pose or, if the belief is mirrored, to the mirrored true pose.
struct PoseRow {
  double position = 0.0;        ///< m, root mean square over all frames of all trials
  double rotation = 0.0;        ///< rad, the same
  double worst_position = 0.0;  ///< m, of the trial in which it is largest
  double worst_rotation = 0.0;  ///< rad, of the trial in which that is largest
  double mirrored = 0.0;        ///< fraction of the frames
  /// Normalized squared error, a mean over the frames: 1 if the belief's covariance is right, more if it is too small.
  double normalized = 0.0;
  double within = 0.0;  ///< fraction of the frames whose error is within the stated 95 % region
  int falls = 0;
  std::optional<double> right_p90;    ///< s from standing again until the belief is right; nothing: too many never were
  std::optional<double> located_p90;  ///< the same, the reflection counts as well
  std::optional<double> first_located_p90;  ///< s since the clock started
  int located_in_time = 0;                  ///< trials with a located belief within kInTime
  static constexpr double kInTime = 10.0;   ///< s
};

/// Nothing if no trial measured it.
std::optional<PoseRow> pose_row_of(const std::vector<TrialResult>& results);

}  // namespace reorient

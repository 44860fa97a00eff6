// SPDX-License-Identifier: MIT
// The part of a trial's outcome that is compared with other trials.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "workbench/experiments/trial/trial_result.h"

namespace reorient {

/// Times in s since the trial's clock started.
struct Outcome {
  std::uint64_t seed = 0;
  bool disturbed = false;  ///< the belief was wrong at the start
  bool failed = false;
  std::optional<double> right_after;      ///< time from which the belief was right and stayed right
  std::optional<double> corrected_after;  ///< time of the command that corrected the belief; nothing: no command did
  std::optional<Reorientation> corrected_by;
  int false_flips = 0;
};

Outcome outcome_of(const TrialResult& result);
std::vector<Outcome> outcomes_of(const std::vector<TrialResult>& results);

}  // namespace reorient

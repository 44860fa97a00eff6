// SPDX-License-Identifier: MIT
#include "workbench/experiments/tables/outcome.h"

namespace reorient {

Outcome outcome_of(const TrialResult& result) {
  return {result.seed,         result.disturbed(), result.failed(), result.right_after, result.corrected_after,
          result.corrected_by, result.false_flips};
}

std::vector<Outcome> outcomes_of(const std::vector<TrialResult>& results) {
  std::vector<Outcome> outcomes;
  outcomes.reserve(results.size());
  for (const TrialResult& result : results) outcomes.push_back(outcome_of(result));
  return outcomes;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
// The columns of each trial, the same in trials.csv and trials.json.
#pragma once

#include <optional>
#include <string>

#include "engine/world/commands.h"
#include "workbench/experiments/trial/trial_result.h"

namespace reorient {

/// Calls visit(name, value) for each column: times in s, commands by their names.
template <typename Visit>
void visit_columns(Visit&& visit, const TrialResult& trial) {
  visit("seed", trial.seed);
  visit("started", trial.started);
  visit("disturbed", trial.disturbed());
  visit("failed", trial.failed());
  visit("measured_s", trial.seconds);
  visit("right_after_s", trial.right_after);
  visit("corrected_after_s", trial.corrected_after);
  visit("corrected_by", trial.corrected_by ? std::optional(std::string(to_string(*trial.corrected_by))) : std::nullopt);
  visit("usable_after_s", trial.usable_after);
  visit("displaced", trial.displaced);
  visit("flips", trial.flips);
  visit("purges", trial.purges);
  visit("resets", trial.resets);
  visit("false_flips", trial.false_flips);
  visit("false_purges", trial.false_purges);
  visit("right_s", trial.right_seconds);
  visit("wrong_s", trial.wrong_seconds);
  visit("uninformative_s", trial.uninformative_seconds);
  visit("ended_uninformative", trial.ended_uninformative);
}

}  // namespace reorient

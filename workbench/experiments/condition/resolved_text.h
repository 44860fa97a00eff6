// SPDX-License-Identifier: MIT
// An experiment as one TOML text without references to other files: condition files are resolved.
#pragma once

#include <string>
#include <vector>

#include "workbench/experiments/condition/condition.h"

namespace reorient {

/// One line for each setting of the patch and of the condition files that it names, as "parameters.trial.learn = 20".
std::vector<std::string> settings_of(const ConditionPatch& patch);

/// The whole experiment. parse_experiment() reads it as the same cells, except for what the command line sets, which is
/// in comments at the end.
std::string resolved_text(const Experiment& experiment);

}  // namespace reorient

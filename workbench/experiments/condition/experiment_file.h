// SPDX-License-Identifier: MIT
// Experiments as TOML files; docs/experiments.md has the keys.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "workbench/experiments/condition/condition.h"

namespace reorient {

/// The condition file of a name. Throws std::runtime_error with one line if it is missing.
using ConditionFiles = std::function<ConditionPatch(const std::string& name)>;

/// `name`: of the file, for messages; its last part without ".toml" is the name of the experiment. `conditions`: reads
/// the named conditions; empty: none may be named. Throws std::runtime_error with one line: file, line, reason.
Experiment parse_experiment(std::string_view text, const std::string& name, const ConditionFiles& conditions = {});
Experiment read_experiment(const std::filesystem::path& file, const ConditionFiles& conditions);

/// A file with the keys of [condition], for several experiments. Throws the same.
ConditionPatch parse_condition(std::string_view text, const std::string& name);
ConditionPatch read_condition(const std::filesystem::path& file);

}  // namespace reorient

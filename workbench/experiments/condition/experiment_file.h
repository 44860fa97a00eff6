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

/// `name`: of the file, for messages; the experiment is called as its last part without ".toml". `conditions`: those
/// that it may name; empty: none. Throws std::runtime_error with one line: file, line, why.
Experiment parse_experiment(std::string_view text, const std::string& name, const ConditionFiles& conditions = {});
Experiment read_experiment(const std::filesystem::path& file, const ConditionFiles& conditions);

/// A file with the keys of [condition], for several experiments. Throws as the above.
ConditionPatch parse_condition(std::string_view text, const std::string& name);
ConditionPatch read_condition(const std::filesystem::path& file);

}  // namespace reorient

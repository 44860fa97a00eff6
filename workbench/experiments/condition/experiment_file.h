// Experiments as TOML files; docs/experiments.md has the keys.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "workbench/experiments/condition/condition.h"

namespace reorient {

/// `name`: of the file, for messages; the experiment is called as its last part without ".toml". Throws
/// std::runtime_error with one line: file, line, why.
Experiment parse_experiment(std::string_view text, const std::string& name);

Experiment read_experiment(const std::filesystem::path& file);

}  // namespace reorient

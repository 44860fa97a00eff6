// SPDX-License-Identifier: MIT
// All checks of scripts without a robot: the findings of `reorient check`.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "workbench/script_tools/check/finding.h"

namespace reorient {

struct CheckResult {
  int files = 0;                  ///< number of checked files
  std::vector<Finding> findings;  ///< sorted by file and position

  int count(Finding::Severity severity) const;
};

/// Loads all behaviors, and each scenario with the behaviors that it requests. Checks their states, and the names in
/// them, in libraries and in tests. `paths` restricts the findings (not the loading) to files and folders; empty:
/// everything below the root. Throws std::runtime_error with one line if a path does not exist or is not below the
/// root.
CheckResult check_scripts(const std::filesystem::path& scripts_root, std::span<const std::filesystem::path> paths);

}  // namespace reorient

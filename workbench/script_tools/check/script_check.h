// SPDX-License-Identifier: MIT
// Everything that can be found wrong with scripts without a robot: what `reorient check` tells.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "workbench/script_tools/check/finding.h"

namespace reorient {

struct CheckResult {
  int files = 0;                  ///< that were looked at
  std::vector<Finding> findings;  ///< by file and place

  int count(Finding::Severity severity) const;
};

/// Loads all behaviors, and each scenario with the behaviors that it wants; then looks at the states and, in these
/// and in libraries and tests, at the names. `paths` restricts what is told (not what is loaded) to files and folders;
/// none: everything below the root. Throws std::runtime_error with one line when a path does not exist or lies
/// elsewhere.
CheckResult check_scripts(const std::filesystem::path& scripts_root, std::span<const std::filesystem::path> paths);

}  // namespace reorient

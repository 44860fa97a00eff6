// SPDX-License-Identifier: MIT
// All checks of scripts without a robot: the findings of `reorient check`.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/script/script_texts.h"
#include "robots/application.h"
#include "workbench/script_tools/check/finding.h"

namespace reorient {

struct CheckResult {
  int files = 0;                  ///< number of checked files
  std::vector<Finding> findings;  ///< sorted by file and position

  int count(Finding::Severity severity) const;
};

/// What is checked. The files are named from the scripts' root.
struct TextsToCheck {
  ScriptTexts scripts;
  std::map<std::string, ScriptText> tests{};       ///< scripted tests
  std::vector<ApplicationInterface> interfaces{};  ///< of applications, any of which a run may have
};

/// The files *_test.lua below tests/, by name, from the root.
std::vector<std::string> scripted_tests(const std::filesystem::path& scripts_root);

/// Loads all behaviors, and each scenario with the behaviors that it requests. Checks their states, and the names in
/// them, in libraries and in tests. Reads no file.
CheckResult check_texts(TextsToCheck texts);

/// The same for the files below the root. `paths` restricts the findings (not the loading) to files and folders; empty:
/// everything below the root. Throws std::runtime_error with one line if a path does not exist or is not below the
/// root.
CheckResult check_scripts(const std::filesystem::path& scripts_root, std::span<const std::filesystem::path> paths);

}  // namespace reorient

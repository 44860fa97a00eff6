// SPDX-License-Identifier: MIT
// Names of scripts on the command line, with suggestions for unknown names; the scripts that others require.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "engine/script/script_texts.h"

namespace reorient {

/// The file below the scripts' root of a scenario ("kidnapped", "scenarios/kidnapped.lua", or a path that leads there).
/// Throws std::runtime_error with one line that suggests the most similar name.
std::string scenario_file(const std::filesystem::path& root, const ScriptTexts& texts, const std::string& name);
/// The same for a behavior.
std::string behavior_file(const std::filesystem::path& root, const ScriptTexts& texts, const std::string& name);

/// For a name without a script below the root: throws std::runtime_error with one line if it is another file.
void require_no_other_file(const std::filesystem::path& root, const std::string& name);

/// These files and all that they require, directly or not. All files, if a script computes the name of a module.
std::set<std::string> with_required(const ScriptTexts& texts, const std::set<std::string>& files);

/// Throws std::runtime_error with one line if the name is not valid for a new script.
void require_script_name(const std::string& name);

}  // namespace reorient

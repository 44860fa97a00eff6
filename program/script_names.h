// SPDX-License-Identifier: MIT
// Scripts as a person names them on the command line, and what was meant where there is none of the name.
#pragma once

#include <filesystem>
#include <string>

#include "engine/script/script_texts.h"

namespace reorient {

/// The file below the scripts' root of a scenario ("kidnapped", "scenarios/kidnapped.lua", or a path that leads there).
/// Throws std::runtime_error with one line that names the nearest right thing.
std::string scenario_file(const std::filesystem::path& root, const ScriptTexts& texts, const std::string& name);
/// The same of a behaviour.
std::string behavior_file(const std::filesystem::path& root, const ScriptTexts& texts, const std::string& name);

/// Of a name of which there is no script below the root: throws std::runtime_error with one line where it is another
/// file.
void require_no_other_file(const std::filesystem::path& root, const std::string& name);

/// Throws std::runtime_error with one line where a new script cannot be called so.
void require_script_name(const std::string& name);

}  // namespace reorient

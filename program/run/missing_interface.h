// SPDX-License-Identifier: MIT
// Warns at the start of a run of values and actions that its behaviors use and its application does not declare.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "engine/script/script_texts.h"
#include "robots/application.h"

namespace reorient {

/// One line for each of the files, as far as an interface that can be named with --interface has the missing names.
/// `files`: from the root of the scripts; the libraries that they require are read, too.
void warn_of_missing_values(const std::filesystem::path& scripts_root, const ScriptTexts& scripts,
                            const std::set<std::string>& files, const ApplicationInterface& declared);

}  // namespace reorient

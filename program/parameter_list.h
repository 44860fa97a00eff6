// SPDX-License-Identifier: MIT
// All parameters that a command line can set.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/parameters/parameter.h"
#include "engine/script/script_texts.h"

namespace reorient {

/// Parameters of the engine with all behaviors, of all scenarios, of every robot, and of the compasses that experiments
/// compare, with these overrides. `body` and `field`: files, or names of shipped ones; empty: the defaults. Throws
/// std::runtime_error with one line if a script or file is invalid.
std::vector<Parameter> all_parameters(const ScriptTexts& texts, const std::filesystem::path& body,
                                      const std::filesystem::path& field,
                                      const std::vector<ParameterChange>& overrides);

}  // namespace reorient

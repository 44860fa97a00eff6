// SPDX-License-Identifier: MIT
// The module of a parameter, and the treatment of values whose module is not loaded: one parameter file can be used for
// all scenarios of a robot.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/parameters/parameter.h"
#include "engine/script/script_texts.h"

namespace reorient {

/// "orientation" of "orientation.lingering".
std::string module_of(std::string_view parameter);
/// The module whose parameters a script declares: "orientation" of "behaviors/orientation.lua".
std::string module_of_script(std::string_view file);

/// Of all existing scripts and robots.
std::set<std::string> all_modules(const ScriptTexts& scripts);

struct ParameterModules {
  std::vector<Parameter> parameters;  ///< that exist in this run
  std::set<std::string> loaded;       ///< also those without parameters
  std::set<std::string> anywhere;     ///< that any run may load
};

/// The overrides of modules that are not loaded in this run. They come from files, and are saved again. A log line
/// warns of each module that no run could load. Throws std::runtime_error with one line about the first invalid
/// override: a name that its module does not have, or one from the command line that would have no effect.
std::vector<ParameterChange> kept_for_others(const std::vector<ParameterChange>& overrides,
                                             const ParameterModules& modules);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Which module a parameter belongs to, and what becomes of values whose module is not there: one file of parameters
// serves a robot in all its scenarios.
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

/// Of all scripts and all robots that there are.
std::set<std::string> all_modules(const ScriptTexts& scripts);

struct ParameterModules {
  std::vector<Parameter> parameters;  ///< that there are in this run
  std::set<std::string> loaded;       ///< also those without parameters
  std::set<std::string> anywhere;     ///< that some run may load
};

/// Those overrides that nobody declares in this run, but which belong to a module that is not there: they come from
/// files, and are to be saved again. One line of log warns of each module that no run could load. Throws
/// std::runtime_error with one line about the first override that is a mistake: a name that its module does not have,
/// or one that the command line sets in vain.
std::vector<ParameterChange> kept_for_others(const std::vector<ParameterChange>& overrides,
                                             const ParameterModules& modules);

}  // namespace reorient

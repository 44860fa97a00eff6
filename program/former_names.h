// SPDX-License-Identifier: MIT
// Names of earlier versions that parameter files and scripts may still have: accepted, with a warning.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/frame.h"
#include "engine/parameters/parameter.h"
#include "engine/script/script_texts.h"

namespace reorient {

/// The present name of a scenario or an experiment; warns once if the given name is a former one.
std::string present_name(const std::string& name);

/// With the present names of parameters of scenarios and of the choice of trial.event; parameters of a scenario that
/// `scripts` still has under its former name are unchanged.
std::vector<ParameterChange> with_present_names(std::vector<ParameterChange> changes, const ScriptTexts& scripts);

/// With the present names of those parameters that only have a new name, each with one warning.
void rename_parameters(std::vector<ParameterChange>& changes);

/// False if it is not a former name.
bool warn_of_former_name(const ParameterChange& change);

/// One warning for each former table, field of the world or function of a library, in each of these files.
void warn_of_former_fields(const ScriptTexts& scripts, const std::set<std::string>& files);

/// The files of all behaviors that are loaded.
std::set<std::string> files_of(const FrameLoop& engine);

}  // namespace reorient

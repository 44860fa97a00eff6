// SPDX-License-Identifier: MIT
// Names of earlier versions that parameter files and scripts may still have: accepted, with a warning.
#pragma once

#include <set>
#include <string>

#include "engine/frame.h"
#include "engine/parameters/parameter.h"
#include "engine/script/script_texts.h"

namespace reorient {

/// False: it is not a former name.
bool warn_of_former_name(const ParameterChange& change);

/// One warning for each former field of the world in each of these files.
void warn_of_former_fields(const ScriptTexts& scripts, const std::set<std::string>& files);

/// The files of all behaviors that are loaded.
std::set<std::string> files_of(const FrameLoop& engine);

}  // namespace reorient

// Overrides of parameters as a TOML file. Tables are prefixes: [orientation] lead = 0.4.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/parameters/parameter.h"

namespace reorient {

/// In the order of the file, each with its line as its source. Throws std::runtime_error with one line: file, line,
/// why.
std::vector<ParameterChange> read_parameters(const std::filesystem::path& file);

/// Writes those that differ from their defaults, and `kept`: values that a file had for modules that are not there
/// (beside the file first, then renamed). Throws std::runtime_error when it cannot.
void save_parameters(const std::vector<Parameter>& parameters, const std::vector<ParameterChange>& kept,
                     const std::filesystem::path& file);

}  // namespace reorient

// Overrides of parameters as a TOML file. Tables are prefixes: [orientation] lead = 0.4.
#pragma once

#include <filesystem>

#include "engine/parameters/parameter_registry.h"

namespace reorient {

/// Names may be declared later. Throws std::runtime_error with one line: file, line, why.
void load_parameters(ParameterRegistry& registry, const std::filesystem::path& file);

/// Writes what differs from the defaults (beside the file first, then renamed). Throws std::runtime_error when it
/// cannot.
void save_parameters(const ParameterRegistry& registry, const std::filesystem::path& file);

}  // namespace reorient

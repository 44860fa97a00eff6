// SPDX-License-Identifier: MIT
// Overrides of parameters as a TOML file. Tables are prefixes: [orientation] lead = 0.4.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/parameters/parameter.h"

namespace reorient {

/// The overrides in the order of their names, each with its line as its source. Throws std::runtime_error with one
/// line: file, line, reason.
std::vector<ParameterChange> read_parameters(const std::filesystem::path& file);

/// The same from the file's text; `name` is for the sources and for the message.
std::vector<ParameterChange> parse_parameters(std::string_view text, const std::string& name);

/// The text of such a file: the parameters that differ from their defaults, and `kept`: values for modules that are not
/// loaded.
std::string parameter_text(const std::vector<Parameter>& parameters, const std::vector<ParameterChange>& kept);

/// Writes that text with a temporary file that it renames. A file that would be replaced by another text is copied to
/// FILE.bak first. Returns the path of the copy; empty: none was needed. Throws std::runtime_error on failure.
std::filesystem::path save_parameters(const std::vector<Parameter>& parameters,
                                      const std::vector<ParameterChange>& kept, const std::filesystem::path& file);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Field dimensions from a TOML file; the keys are documented in assets/fields/README.md.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/field_dimensions.h"

namespace reorient {

/// Throws std::runtime_error with one line that names the file, the key and the fix: a file that is missing or is
/// not TOML, an unknown or missing key, a value of the wrong type or out of range.
FieldDimensions load_field(const std::filesystem::path& file);

/// The same from the file's text; `name` is for the message.
FieldDimensions parse_field(std::string_view text, const std::string& name);

}  // namespace reorient

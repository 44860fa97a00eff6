// Field dimensions from a TOML file; the keys are documented in assets/fields/README.md.
#pragma once

#include <filesystem>

#include "geometry/field_dimensions.h"

namespace reorient {

/// Throws std::runtime_error with one line that names the file, the key and the fix: a file that is missing or is
/// not TOML, an unknown or missing key, a value of the wrong type or out of range.
FieldDimensions load_field(const std::filesystem::path& file);

}  // namespace reorient

// How one robot's cameras are mounted, from a TOML file with a table for each: `[upper]`, `[lower]` with `tilt_degrees`
// (downwards) and `pan_degrees` (to the left).
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/camera_offset.h"

namespace reorient {

/// Of the upper and the lower camera.
using Calibration = std::array<CameraOffset, 2>;

/// Throws std::runtime_error with one line that names the file, the line and what is wrong.
Calibration load_calibration(const std::filesystem::path& file);
/// The same from the file's text; `name` is for the message.
Calibration parse_calibration(std::string_view text, const std::string& name);
/// As such a file.
std::string to_toml(const Calibration& calibration);

}  // namespace reorient

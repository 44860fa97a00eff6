// SPDX-License-Identifier: MIT
// How one robot's cameras are mounted, from a TOML file with a table for each: `[upper]`, `[lower]` with `tilt_degrees`
// (downwards), `pan_degrees` (to the left), `roll_degrees` (left side up) and `height_m` (upwards). Footage has the
// upper camera. `[footage]` with `recorded_pitch` or `recorded_roll` = false: what was recorded of single images does
// not belong to them, and 0 is used instead.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/camera_attitude.h"
#include "geometry/camera_offset.h"

namespace reorient {

struct Calibration {
  std::array<CameraOffset, 2> offsets;  ///< of the upper and the lower camera
  RecordedAttitude recorded;            ///< of footage
};

/// Throws std::runtime_error with one line that names the file, the line and what is wrong.
Calibration load_calibration(const std::filesystem::path& file);
/// The same from the file's text; `name` is for the message.
Calibration parse_calibration(std::string_view text, const std::string& name);
/// As such a file.
std::string to_toml(const Calibration& calibration);
/// Another number for another calibration, and never 0, which means cameras as in the data sheet.
std::uint64_t mounting_of(const Calibration& calibration);

}  // namespace reorient

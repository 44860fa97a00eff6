// SPDX-License-Identifier: MIT
// Mounting of one robot's cameras, from a TOML file with a table for each: `[upper]`, `[lower]` with `tilt_degrees`
// (downwards), `pan_degrees` (to the left), `roll_degrees` (left side up) and `height_m` (upwards). Footage has the
// upper camera. `[footage]` with `recorded_pitch` or `recorded_roll` = false: ignores the recorded angles of single
// images, and uses 0 instead.
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

/// Throws std::runtime_error with one line with file, line, what was expected and what was found.
Calibration load_calibration(const std::filesystem::path& file);
/// The same from the file's text; `name` is for the message.
Calibration parse_calibration(std::string_view text, const std::string& name);
/// The text of such a file.
std::string to_toml(const Calibration& calibration);
/// A number that identifies the calibration, never 0, which means cameras as in the data sheet.
std::uint64_t mounting_of(const Calibration& calibration);

}  // namespace reorient

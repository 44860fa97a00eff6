// SPDX-License-Identifier: MIT
// A robot's body from a TOML file; the keys are documented in assets/robots/README.md.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "robots/robot_body.h"

namespace reorient {

/// Throws std::runtime_error with one line with file, line, what was expected and what was found: a file that is
/// missing or is not TOML, an unknown or missing key, a value of the wrong type or out of range.
RobotBody load_body(const std::filesystem::path& file);

/// The same from the file's text; `name` is for the message.
RobotBody parse_body(std::string_view text, const std::string& name);

}  // namespace reorient

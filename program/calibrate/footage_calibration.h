// SPDX-License-Identifier: MIT
// `reorient calibrate --footage`: the offset of a camera's mounting from recorded images, by field lines or by vertical
// edges.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "program/run/footage_arguments.h"

namespace reorient {

struct FootageCalibrationOptions {
  std::filesystem::path source;
  FootageArguments footage;
  std::filesystem::path body, field;
  std::string by = "auto";  ///< or "lines", "edges"
  std::filesystem::path out, pictures;
};

/// The exit code. Throws std::runtime_error with one line on bad input.
int calibrate_by_footage(const FootageCalibrationOptions& options, std::ostream& out);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Pictures as PNG files.
#pragma once

#include <filesystem>

#include "workbench/views/pictures/canvas/picture.h"

namespace reorient::pictures {

/// Writes a picture beside its final name and renames it when it is complete, so that no process reads an incomplete
/// picture. Throws std::runtime_error with one line if that fails, and leaves an existing file unchanged.
void write_png(const std::filesystem::path& file, const Picture& picture);

}  // namespace reorient::pictures

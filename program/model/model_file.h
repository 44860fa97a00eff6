// SPDX-License-Identifier: MIT
// A saved model of a room as a file.
#pragma once

#include <filesystem>

#include "perception/room/saved_model.h"

namespace reorient {

/// Throws std::runtime_error with a short reason, without the file's name.
SavedModel read_model_file(const std::filesystem::path& file);

/// Writes a temporary file and renames it. Throws std::runtime_error with one line; the file is then unchanged.
void write_model_file(const SavedModel& model, const std::filesystem::path& file);

}  // namespace reorient

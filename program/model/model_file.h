// SPDX-License-Identifier: MIT
// A saved model of a room as a file.
#pragma once

#include <filesystem>

#include "perception/room/saved_model.h"

namespace reorient {

/// Throws std::runtime_error, which says in a few words what is wrong with the file.
SavedModel read_model_file(const std::filesystem::path& file);

/// Writes beside the file first, then renames. Throws std::runtime_error with one line; then the file is as it was.
void write_model_file(const SavedModel& model, const std::filesystem::path& file);

}  // namespace reorient

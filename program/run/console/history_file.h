// SPDX-License-Identifier: MIT
// The lines typed in earlier runs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reorient {

/// $XDG_STATE_HOME/reorient/history, else ~/.local/state/reorient/history; nothing if neither folder is known.
std::optional<std::filesystem::path> history_path();

inline constexpr std::size_t kMostHistory = 500;  ///< lines; older ones are removed

/// The latest lines, oldest first; invalid lines are left out. Empty without a file.
/// Throws std::runtime_error with one line if it is not a plain file (a link, a device) or cannot be read.
std::vector<std::string> read_history(const std::filesystem::path& file);

/// Appends to the present file, since another run may have written to it. Throws std::runtime_error with one line.
void append_history(const std::filesystem::path& file, const std::vector<std::string>& lines);

}  // namespace reorient

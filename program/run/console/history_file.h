// SPDX-License-Identifier: MIT
// What was typed in earlier runs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reorient {

/// $XDG_STATE_HOME/reorient/history, else ~/.local/state/reorient/history; nothing where neither folder is known.
std::optional<std::filesystem::path> history_path();

inline constexpr std::size_t kMostHistory = 500;  ///< lines; older ones are forgotten

/// The latest lines, oldest first; what no prompt can have written is left out. None where there is no such file.
/// Throws std::runtime_error with one line where it is no plain file (a link, a device) or cannot be read.
std::vector<std::string> read_history(const std::filesystem::path& file);

/// Adds to what the file holds by now: another run may have written meanwhile. Throws std::runtime_error with one line.
void append_history(const std::filesystem::path& file, const std::vector<std::string>& lines);

}  // namespace reorient

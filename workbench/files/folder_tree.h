// SPDX-License-Identifier: MIT
// All files and folders below a folder, also behind links, as package managers and `colcon --symlink-install` make
// them.
#pragma once

#include <filesystem>
#include <functional>

namespace reorient {

/// Calls `visit` for each entry below the folder. Skips folders that cannot be read, and does not enter a folder within
/// itself, since links may lead in a circle. An error ends the listing and is returned, for example that a folder was
/// removed meanwhile. `visit` may throw.
std::error_code visit_below(const std::filesystem::path& folder,
                            const std::function<void(const std::filesystem::directory_entry&)>& visit);

}  // namespace reorient

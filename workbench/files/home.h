// SPDX-License-Identifier: MIT
// Where the project's scripts and data files are.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace reorient {

/// The folder with scripts/ and assets/: $REORIENT_HOME, else the first folder above the running program that is the
/// project's, or an installation's (in share/reorient). Throws std::runtime_error if neither exists.
std::filesystem::path find_home();
/// The project or installation that contains the folder, if it is not find_home(). Then the user may expect its scripts
/// to run. Empty: none.
std::filesystem::path other_home_around(const std::filesystem::path& folder);

/// "paper" as assets/parameters/paper.toml, "light/hard" as assets/parameters/light/hard.toml, if an asset with
/// one of the extensions exists and no file has that path; everything else is a path. A folder of that name does not
/// count: the project itself has a folder "localization".
std::filesystem::path asset_file(std::string_view folder, const std::filesystem::path& named,
                                 std::span<const std::string_view> extensions);
/// Whether the path may be the name of an asset: it has no extension and does not begin with "/" or ".".
bool is_asset_name(const std::filesystem::path& named);
/// The names of the existing assets.
std::vector<std::string> asset_names(std::string_view folder, std::span<const std::string_view> extensions);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Initial pose of each player before a game, from a TOML file: `player_2 = [-3.2, -3.0, 90.0]`, in m, m and
// degrees, in the team's axes.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/pose2.h"

namespace reorient {

inline constexpr std::size_t kMostPlayers = 20;
/// The poses of the players 1 to 20.
using Places = std::array<std::optional<Pose2>, kMostPlayers>;

/// Throws std::runtime_error with one line with file, line, what was expected and what was found.
Places load_places(const std::filesystem::path& file);
/// The same from the file's text; `name` is for the message.
Places parse_places(std::string_view text, const std::string& name);

}  // namespace reorient

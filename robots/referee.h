// SPDX-License-Identifier: MIT
// What the referee says.
#pragma once

#include <string_view>

#include "geometry/const_or.h"

namespace reorient {

/// Of the game, as the league's rules call it.
enum class GameState { unknown, initial, ready, set, playing, finished, standby };
constexpr int enum_count(GameState) { return 7; }
/// "unknown": as scripts call it.
std::string_view to_string(GameState state);

/// Who kicks off next, or takes the free kick.
enum class KickOff { nobody, ours, theirs };
constexpr int enum_count(KickOff) { return 3; }
/// "nobody": as scripts call it.
std::string_view to_string(KickOff kick_off);

struct RefereeState {
  bool penalized = false;  ///< this robot
  GameState state = GameState::unknown;
  bool stopped = false;  ///< the whole game: nobody may move
  KickOff kick_off = KickOff::nobody;
  bool operator==(const RefereeState&) const = default;
};
template <typename Visit, ConstOr<RefereeState> T>
void fields(Visit&& visit, T& referee) {
  visit(referee.penalized, referee.state, referee.stopped, referee.kick_off);
}

/// Whether the rules let the robot walk: it is in the game, and that goes on, or is to begin.
bool may_walk(const RefereeState& referee);

}  // namespace reorient

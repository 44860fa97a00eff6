// SPDX-License-Identifier: MIT
// State of the game and of the robot as set by the referee.
#pragma once

#include <string_view>

#include "geometry/const_or.h"

namespace reorient {

/// States of the game, named as in the rules of the league.
enum class GameState { unknown, initial, ready, set, playing, finished, standby };
constexpr int enum_count(GameState) { return 7; }
/// Name of the state in scripts.
std::string_view to_string(GameState state);

/// The team that kicks off next or takes the free kick.
enum class KickOff { none, ours, theirs };
constexpr int enum_count(KickOff) { return 3; }
/// Name of the team in scripts.
std::string_view to_string(KickOff kick_off);

struct RefereeState {
  bool penalized = false;  ///< this robot is penalized
  GameState state = GameState::unknown;
  bool stopped = false;  ///< the whole game is stopped: no robot may move
  KickOff kick_off = KickOff::none;
  bool operator==(const RefereeState&) const = default;
};
template <typename Visit, ConstOr<RefereeState> T>
void fields(Visit&& visit, T& referee) {
  visit(referee.penalized, referee.state, referee.stopped, referee.kick_off);
}

/// Whether the rules allow the robot to walk: it is not penalized, and the game runs or is about to start.
bool may_walk(const RefereeState& referee);

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "robots/referee.h"

#include <array>
#include <cstddef>

namespace reorient {

std::string_view to_string(GameState state) {
  constexpr std::array<std::string_view, enum_count(GameState{})> kNames{"unknown", "initial",  "ready",  "set",
                                                                         "playing", "finished", "standby"};
  return kNames[static_cast<std::size_t>(state)];
}

std::string_view to_string(KickOff kick_off) {
  constexpr std::array<std::string_view, enum_count(KickOff{})> kNames{"nobody", "ours", "theirs"};
  return kNames[static_cast<std::size_t>(kick_off)];
}

bool may_walk(const RefereeState& referee) {
  if (referee.penalized || referee.stopped) return false;
  return referee.state == GameState::unknown || referee.state == GameState::ready ||
         referee.state == GameState::playing;
}

}  // namespace reorient

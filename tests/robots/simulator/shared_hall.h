// SPDX-License-Identifier: MIT
// The hall that tests share, because painting one takes longer than most tests.
#pragma once

#include "robots/simulator/room/room.h"

namespace reorient {

inline const Room& shared_hall() {
  static const Room room = procedural_hall(1, RoomShape{});
  return room;
}

}  // namespace reorient

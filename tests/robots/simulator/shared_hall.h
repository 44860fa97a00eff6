// SPDX-License-Identifier: MIT
// The hall that tests share, since painting one takes longer than most of them.
#pragma once

#include "robots/simulator/room/room.h"

namespace reorient {

inline const Room& shared_hall() {
  static const Room room = procedural_hall(1, RoomShape{});
  return room;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
// The color of the status of the room. The live page and the reports of experiments use the same colors.
#pragma once

#include "engine/world/world.h"
#include "workbench/views/pictures/canvas/picture.h"

namespace reorient::pictures {

inline Color status_color(RoomStatus status) {
  switch (status) {
    case RoomStatus::usable:
      return palette::usable_band;
    case RoomStatus::off:
    case RoomStatus::resting:
      return palette::idle_band;
    case RoomStatus::unlearned:
    case RoomStatus::symmetric:
    case RoomStatus::lost:
    case RoomStatus::fresh:
      return palette::undecided_band;
  }
  return palette::idle_band;
}

}  // namespace reorient::pictures

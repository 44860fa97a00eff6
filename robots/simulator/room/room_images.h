// SPDX-License-Identifier: MIT
// The pictures of a room's surfaces before they become textures. Here a room becomes symmetric or loses its colors.
#pragma once

#include <string>

#include "robots/simulator/room/room.h"

namespace reorient {

/// Pictures of one room: the walls once around, ceiling and floor from above, each in the layout of its texture.
struct RoomImages {
  LinearImage walls;
  LinearImage ceiling;
  LinearImage floor;
};

/// Repeats one half (or quarter) of the pictures, according to the shape's symmetry and its strength.
void make_symmetric(RoomImages& images, const RoomShape& shape);

/// The room, with its colors reduced as its shape requests.
Room room_of(RoomImages images, const std::string& name, const RoomShape& shape, const LinearColor& light);

}  // namespace reorient

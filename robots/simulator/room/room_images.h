// SPDX-License-Identifier: MIT
// What is painted on a room's surfaces before it becomes textures. Here a room is made symmetric and its colors fade.
#pragma once

#include <string>

#include "robots/simulator/room/room.h"

namespace reorient {

/// Pictures of one room: walls once around, ceiling and floor from above, each as its texture wants it.
struct RoomImages {
  LinearImage walls;
  LinearImage ceiling;
  LinearImage floor;
};

/// Repeats one half of the pictures as the other half, as the shape's symmetry and its strength say.
void make_symmetric(RoomImages& images, const RoomShape& shape);

/// The room, with the share of its colors that its shape asks for.
Room room_of(RoomImages images, const std::string& name, const RoomShape& shape, const LinearColor& light);

}  // namespace reorient

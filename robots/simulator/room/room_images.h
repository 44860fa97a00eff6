// What is painted on a room's surfaces before it becomes textures; here a room can be made harder to know one's way in.
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

/// The room, with the symmetry and the colours that its shape asks for.
Room room_of(RoomImages images, const std::string& name, const RoomShape& shape, const LinearColor& light);

}  // namespace reorient

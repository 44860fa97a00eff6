// SPDX-License-Identifier: MIT
// What stands between the field and the walls: cabinets, pillars and partitions. It hides what is behind it, and from
// another place it hides something else (occlusion and parallax).
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "geometry/field_dimensions.h"
#include "robots/simulator/room/room.h"

namespace reorient {

struct FurnitureParameters {
  int pieces = 0;
  int seed = 1;
};

template <typename Visit>
void describe(FurnitureParameters& p, Visit&& visit) {
  visit("pieces", p.pieces, 0, 200, "", "cabinets, pillars and partitions that stand between the carpet and the walls");
  visit("seed", p.seed, 0, 1000000, "", "which pieces these are, and where they stand");
}

/// A box that stands on the floor. Each of its sides shows a piece of the room's walls, so that it has colors that
/// occur in this room.
struct FurniturePiece {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< m, field frame
  double rotation = 0.0;                             ///< rad, of its long side to the x axis
  double length = 1.0;                               ///< m
  double depth = 0.5;                                ///< m
  double height = 1.0;                               ///< m
  double picture = 0.0;                              ///< wall coordinate where its picture begins, m
};

/// No piece stands on the carpet or within 0.3 m of it, and none in a wall. Fewer than asked for where there is no
/// space. In a room with a symmetry each piece has a twin after half a turn.
std::vector<FurniturePiece> furnish(const FurnitureParameters& parameters, const RoomShape& room,
                                    const FieldDimensions& field);

}  // namespace reorient

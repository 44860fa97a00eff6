// SPDX-License-Identifier: MIT
// Cabinets, pillars and partitions between the field and the walls, which give the room occlusion and parallax.
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
  visit("pieces", p.pieces, 0, 200, "",
        "number of cabinets, pillars and partitions between the carpet and the walls; fewer if there is no space");
  visit("seed", p.seed, 0, 1000000, "", "seed of the shapes and positions of the furniture");
}

/// A box on the floor. Its sides show parts of the room's walls, so that its colors occur in this room.
struct FurniturePiece {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< m, field frame
  double rotation = 0.0;                             ///< rad, of its long side to the x axis
  double length = 1.0;                               ///< m
  double depth = 0.5;                                ///< m
  double height = 1.0;                               ///< m
  double picture = 0.0;                              ///< m, wall coordinate at which its picture begins
};

/// Places furniture in a room: never in a wall, on the carpet or within 0.3 m of it. Returns fewer pieces than
/// requested if there is no space. In a symmetric room each piece has a twin at the mirrored pose.
std::vector<FurniturePiece> furnish(const FurnitureParameters& parameters, const RoomShape& room,
                                    const FieldDimensions& field);

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "robots/simulator/room/furniture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/random.h"
#include "geometry/transform.h"

namespace reorient {
namespace {

constexpr double kFromCarpet = 0.3;  // m
constexpr double kFromWall = 0.1;    // m

/// A pillar is as high as the room.
FurniturePiece any_piece(double room_height, Random& random) {
  FurniturePiece piece;
  const double kind = random.uniform();
  if (kind < 0.15) {
    piece.length = piece.depth = random.uniform(0.3, 0.6);
    piece.height = room_height;
  } else if (kind < 0.45) {
    piece.length = random.uniform(1.5, 4.0);
    piece.depth = 0.08;
    piece.height = std::min(random.uniform(1.8, 2.6), room_height);
  } else {
    piece.length = random.uniform(0.6, 1.6);
    piece.depth = random.uniform(0.3, 0.6);
    piece.height = std::min(random.uniform(0.8, 2.2), room_height);
  }
  return piece;
}

/// Whether the piece stands beside the carpet and in the room. Piece and carpet are convex, so they do not overlap if a
/// line separates them; for boxes it is enough to test their own sides.
bool has_space(const FurniturePiece& piece, const RoomShape& room, const FieldDimensions& field) {
  const Eigen::Vector2d along = 0.5 * piece.length * unit_vector(piece.rotation);
  const Eigen::Vector2d across = 0.5 * piece.depth * unit_vector(piece.rotation + 0.5 * kPi);
  const Eigen::Vector2d extent = along.cwiseAbs() + across.cwiseAbs();
  const Eigen::Vector2d carpet = carpet_half_size(field) + Eigen::Vector2d::Constant(kFromCarpet);
  const Eigen::Vector2d away = piece.center.cwiseAbs();
  const auto beyond = [&](const Eigen::Vector2d& half) {
    const Eigen::Vector2d normal = half.normalized();
    return std::abs(normal.dot(piece.center)) > half.norm() + normal.cwiseAbs().dot(carpet);
  };
  if (!((away - extent - carpet).array() > 0.0).any() && !beyond(along) && !beyond(across)) return false;
  if (room.form == RoomForm::cylinder) return piece.center.norm() + extent.norm() <= 0.5 * room.length - kFromWall;
  const Eigen::Vector2d walls(0.5 * room.length - kFromWall, 0.5 * room.width - kFromWall);
  return ((away + extent - walls).array() <= 0.0).all();
}

}  // namespace

std::vector<FurniturePiece> furnish(const FurnitureParameters& parameters, const RoomShape& room,
                                    const FieldDimensions& field) {
  constexpr std::uint64_t kStream = 0xf0491;
  constexpr int kTries = 30;  // random positions for one piece
  Random random(static_cast<std::uint64_t>(parameters.seed), kStream);
  const bool has_twins = room.symmetry != RoomSymmetry::none;
  std::vector<FurniturePiece> pieces;
  for (int i = 0; i < (has_twins ? parameters.pieces / 2 : parameters.pieces); ++i) {
    FurniturePiece piece = any_piece(room.height, random);
    piece.picture = random.uniform(0.0, wall_perimeter(room));
    for (int attempt = 0; attempt < kTries; ++attempt) {
      const Eigen::Vector2d wall = wall_point(room, random.uniform(0.0, wall_perimeter(room)));
      piece.center = random.uniform(0.3, 1.0) * wall;
      const bool beside = std::abs(wall.x()) * floor_extent(room).y() < std::abs(wall.y()) * floor_extent(room).x();
      piece.rotation = (beside ? 0.0 : 0.5 * kPi) + random.uniform(-0.3, 0.3);
      if (!has_space(piece, room, field)) continue;
      pieces.push_back(piece);
      if (has_twins) {
        piece.center = -piece.center;
        piece.rotation += kPi;
        pieces.push_back(piece);
      }
      break;
    }
  }
  return pieces;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "robots/simulator/room/furniture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/transform.h"
#include "robots/simulator/render/renderer.h"
#include "tests/robots/simulator/shared_hall.h"

namespace reorient {
namespace {

std::array<Eigen::Vector2d, 4> corners_of(const FurniturePiece& piece) {
  const Eigen::Vector2d along = 0.5 * piece.length * unit_vector(piece.rotation);
  const Eigen::Vector2d across = 0.5 * piece.depth * unit_vector(piece.rotation + 0.5 * kPi);
  return {piece.center - along - across, piece.center + along - across, piece.center + along + across,
          piece.center - along + across};
}

/// Whether a point of the carpet, in steps of 0.1 m, lies under the piece.
bool stands_on_carpet(const FurniturePiece& piece, const FieldDimensions& field) {
  const double half_length = 0.5 * field.length + field.border;
  const double half_width = 0.5 * field.width + field.border;
  for (double x = -half_length; x <= half_length; x += 0.1) {
    for (double y = -half_width; y <= half_width; y += 0.1) {
      const Eigen::Vector2d inside = Eigen::Vector2d(x, y) - piece.center;
      if (std::abs(inside.dot(unit_vector(piece.rotation))) < 0.5 * piece.length &&
          std::abs(inside.dot(unit_vector(piece.rotation + 0.5 * kPi))) < 0.5 * piece.depth)
        return true;
    }
  }
  return false;
}

RC_GTEST_PROP(Furniture, StandsBetweenTheCarpetAndTheWalls, ()) {
  const FieldDimensions field;
  RoomShape room;
  room.form = *rc::gen::element(RoomForm::box, RoomForm::cylinder);
  room.length = *rc::gen::inRange(140, 240) * 0.1;
  room.width = *rc::gen::inRange(100, 200) * 0.1;
  const FurnitureParameters parameters{*rc::gen::inRange(0, 40), *rc::gen::inRange(0, 1000)};
  const std::vector<FurniturePiece> pieces = furnish(parameters, room, field);
  RC_ASSERT(static_cast<int>(pieces.size()) <= parameters.pieces);
  for (const FurniturePiece& piece : pieces) {
    RC_ASSERT(piece.height <= room.height);
    RC_ASSERT(!stands_on_carpet(piece, field));
    for (const Eigen::Vector2d& corner : corners_of(piece)) {
      if (room.form == RoomForm::cylinder) {
        RC_ASSERT(corner.norm() < 0.5 * room.length);
      } else {
        RC_ASSERT(std::abs(corner.x()) < 0.5 * room.length && std::abs(corner.y()) < 0.5 * room.width);
      }
    }
  }
}

TEST(Furniture, FindsSpaceInAnOrdinaryRoom) {
  EXPECT_EQ(furnish({30, 1}, RoomShape{}, FieldDimensions{}).size(), 30u);
  EXPECT_TRUE(furnish({0, 1}, RoomShape{}, FieldDimensions{}).empty());
}

TEST(Furniture, HasTwinsInASymmetricRoom) {
  RoomShape room;
  room.symmetry = RoomSymmetry::two_fold;
  const std::vector<FurniturePiece> pieces = furnish({20, 3}, room, FieldDimensions{});
  ASSERT_EQ(pieces.size(), 20u);
  for (std::size_t i = 0; i < pieces.size(); i += 2) {
    EXPECT_EQ(pieces[i].center, -pieces[i + 1].center);
    EXPECT_EQ(pieces[i].picture, pieces[i + 1].picture);
    EXPECT_EQ(pieces[i].height, pieces[i + 1].height);
  }
}

/// A camera above the field's center that looks along +x, 1 m above the floor.
Isometry3 camera_at(double x, double y, double rotation) {
  Isometry3 pose = to_isometry(Pose2(x, y, rotation));
  pose.translation().z() = 1.0;
  return pose;
}

TEST(Furniture, OccludesTheWallBehindItWithParallax) {
  const CameraModel camera = CameraModel::from_fields_of_view(160, 120, from_degrees(56.3), from_degrees(43.7));
  Renderer renderer(camera, FieldDimensions{}, shared_hall(), true);
  Scene scene;
  FurniturePiece piece;
  piece.center = {6.5, 0.0};
  piece.rotation = 0.5 * kPi;
  piece.length = 1.0;
  piece.depth = 0.4;
  piece.height = 2.0;
  add_furniture(scene, piece, wall_perimeter(shared_hall().shape));
  const auto nearest = [&](const Isometry3& from) {
    const Frame& frame = renderer.render(from, scene);
    const auto row = frame.depth.begin() + static_cast<std::ptrdiff_t>(frame.row(60));
    const auto least = std::min_element(row, row + frame.width);
    return std::pair(*least, static_cast<int>(least - row));
  };
  const auto [ahead, ahead_column] = nearest(camera_at(0.0, 0.0, 0.0));
  EXPECT_NEAR(ahead, 6.3, 1e-3) << "its front";
  EXPECT_NEAR(renderer.frame().depth[renderer.frame().row(60) + 20], 8.4, 1e-3) << "the wall beside it";
  EXPECT_NEAR(ahead_column, 80, 13);
  // Seen from one meter to the left, it appears to the right of the wall behind it.
  const auto [aside, aside_column] = nearest(camera_at(0.0, 1.0, 0.0));
  EXPECT_NEAR(aside, 6.3, 1e-3);
  EXPECT_NEAR(aside_column, 80 + camera.focal.x() / 6.3, 14);
  EXPECT_EQ(renderer.frame().labels[renderer.frame().row(60) + static_cast<std::size_t>(aside_column)], Label::wall);
}

TEST(Furniture, IsTheSameInEachRun) {
  const CameraModel camera = CameraModel::from_fields_of_view(160, 120, from_degrees(56.3), from_degrees(43.7));
  Renderer renderer(camera, FieldDimensions{}, shared_hall(), false);
  Scene scene;
  for (const FurniturePiece& piece : furnish({40, 5}, shared_hall().shape, FieldDimensions{}))
    add_furniture(scene, piece, wall_perimeter(shared_hall().shape));
  const std::vector<float> first = renderer.render(camera_at(1.0, 1.0, 0.7), scene).red;
  Renderer other(camera, FieldDimensions{}, shared_hall(), false);
  EXPECT_EQ(other.render(camera_at(1.0, 1.0, 0.7), scene).red, first);
  EXPECT_NE(other.render(camera_at(1.0, 1.0, 0.7), Scene{}).red, first);
}

}  // namespace
}  // namespace reorient

#include "robots/simulator/room/room.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

Eigen::Array3f color_of(const Texture& texture, double u, double v, int level) {
  const Texture::Color color = texture.sample(static_cast<float>(u), static_cast<float>(v), level);
  return {color[0], color[1], color[2]};
}

RoomShape round_room() {
  RoomShape shape;
  shape.form = RoomForm::cylinder;
  return shape;
}

RC_GTEST_PROP(RoomShape, GoesOnceAroundInTheWallCoordinateOfABox, ()) {
  const RoomShape shape;
  const double along = *rc::gen::inRange(0, 59200) * 1e-3;
  const Eigen::Vector2d point = wall_point(shape, along);
  const bool on_end = std::abs(std::abs(point.x()) - 8.4) < 1e-9 && std::abs(point.y()) < 6.4 + 1e-9;
  const bool on_side = std::abs(std::abs(point.y()) - 6.4) < 1e-9 && std::abs(point.x()) < 8.4 + 1e-9;
  RC_ASSERT(on_end || on_side);
  RC_ASSERT((wall_point(shape, along + wall_perimeter(shape)) - point).norm() < 1e-6);
  RC_ASSERT((wall_point(shape, along + 1e-4) - point).norm() < 1e-4 + 1e-9);
}

TEST(RoomShape, OfHalfATurnIsTheOppositePointOfTheWall) {
  for (const RoomShape& shape : {RoomShape{}, round_room()}) {
    for (double along = 0.1; along < 20.0; along += 1.3) {
      const Eigen::Vector2d opposite = wall_point(shape, along + 0.5 * wall_perimeter(shape));
      EXPECT_LT((wall_point(shape, along) + opposite).norm(), 1e-9);
    }
  }
}

TEST(RoomShape, ThatCannotBeBuiltIsRefused) {
  RoomShape shape;
  shape.length = 3.0;
  EXPECT_THROW(procedural_hall(1, shape), std::runtime_error);
  shape = RoomShape{};
  shape.height = std::nan("");
  EXPECT_THROW(procedural_hall(1, shape), std::runtime_error);
  shape = RoomShape{};
  shape.viewpoint_height = 9.0;
  EXPECT_THROW(procedural_hall(1, shape), std::runtime_error);
}

TEST(RoomShape, GrowsWithTheField) {
  FieldDimensions field;
  EXPECT_EQ(room_shape_for(field).length, RoomShape().length);
  EXPECT_EQ(room_shape_for(field).width, RoomShape().width);
  field.length += 5.0;
  field.width += 3.0;
  EXPECT_DOUBLE_EQ(room_shape_for(field).length, RoomShape().length + 5.0);
  EXPECT_DOUBLE_EQ(room_shape_for(field).width, RoomShape().width + 3.0);
}

TEST(Texture, KeepsItsMeanOnEveryLevel) {
  LinearImage image(128, 64);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x)
      image.at(x, y) = LinearColor::Constant((x / 8 + y / 8) % 2 == 0 ? 0.25f : 0.75f);
  }
  const Texture texture(image, {}, {2.0, 1.0}, Texture::Edge::wrap);
  EXPECT_NEAR(color_of(texture, 0.03, 0.03, 0).x(), 0.25f, 1e-3f);
  for (int level = 4; level < Texture::kLevels; ++level) {
    EXPECT_NEAR(color_of(texture, 0.7, 0.4, level).x(), 0.5f, 1e-3f) << "level " << level;
  }
}

TEST(Texture, MeetsItselfWhereItWrapsAround) {
  LinearImage image(64, 64, LinearColor::Constant(0.5f));
  for (int y = 0; y < image.height; ++y) image.at(63, y) = LinearColor::Ones();
  const Texture texture(image, {}, {1.0, 1.0}, Texture::Edge::wrap);
  EXPECT_NEAR(color_of(texture, 0.0, 0.5, 0).x(), color_of(texture, 1.0, 0.5, 0).x(), 1e-3f);
  EXPECT_NEAR(color_of(texture, 0.0, 0.5, 0).x(), 0.75f, 1e-3f);
}

TEST(Texture, StaysInsideForCoordinatesABitOutside) {
  const Texture texture(LinearImage(64, 64, LinearColor::Constant(0.5f)), {}, {1.0, 1.0}, Texture::Edge::clamp);
  for (const double outside : {-5.0, -1e-6, 1.0 + 1e-6, 7.0}) {
    EXPECT_NEAR(color_of(texture, outside, outside, 0).x(), 0.5f, 1e-3f);
  }
}

TEST(ProceduralHall, IsTheSameForTheSameSeedAndAnotherOneForAnother) {
  const Room hall = procedural_hall(5, RoomShape{});
  const Room again = procedural_hall(5, RoomShape{});
  const Room other = procedural_hall(6, RoomShape{});
  double difference = 0.0;
  for (double along = 0.0; along < 59.0; along += 0.37) {
    EXPECT_TRUE((color_of(hall.walls, along, 1.7, 1) == color_of(again.walls, along, 1.7, 1)).all());
    difference += (color_of(hall.walls, along, 1.7, 4) - color_of(other.walls, along, 1.7, 4)).abs().sum();
  }
  EXPECT_GT(difference, 1.0);
}

/// The greatest difference of any channel between a room and itself after `turns` quarters of a turn.
float difference_after_quarters(const Room& room, int quarters) {
  float greatest = 0.0f;
  for (int side = 0; side < 4; ++side) {
    const int other = (side + quarters) % 4;
    for (double share = 0.02; share < 1.0; share += 0.04) {
      const auto at = [&](int wall) {
        const double begin = wall_begin(room.shape, wall);
        return begin + share * (wall_begin(room.shape, wall + 1) - begin);
      };
      for (double height = 0.5; height < 5.0; height += 0.5)
        greatest = std::max(
            greatest,
            (color_of(room.walls, at(side), height, 2) - color_of(room.walls, at(other), height, 2)).abs().maxCoeff());
    }
  }
  return greatest;
}

TEST(SymmetricRoom, LooksTheSameAfterHalfATurn) {
  RoomShape shape;
  shape.symmetry = RoomSymmetry::two_fold;
  const Room room = procedural_hall(1, shape);
  EXPECT_LT(difference_after_quarters(room, 2), 1e-3f);
  EXPECT_GT(difference_after_quarters(room, 1), 0.2f);
  for (const double x : {1.0, 4.0, 9.0}) {
    const Eigen::Vector2d extent = floor_extent(shape);
    const Eigen::Array3f here = color_of(room.floor, x, 3.0, 0);
    EXPECT_LT((here - color_of(room.floor, extent.x() - x, extent.y() - 3.0, 0)).abs().maxCoeff(), 1e-3f);
  }
}

TEST(SymmetricRoom, OfFourEqualWallsLooksMuchTheSameAfterAQuarter) {
  RoomShape shape;
  shape.width = shape.length;
  shape.symmetry = RoomSymmetry::four_fold;
  EXPECT_LT(difference_after_quarters(procedural_hall(1, shape), 1), 0.1f);
}

TEST(ColorlessRoom, IsGreyAndAsBrightAsBefore) {
  RoomShape shape;
  const Room colored = procedural_hall(1, shape);
  shape.color = 0.0;
  const Room grey = procedural_hall(1, shape);
  for (double along = 0.5; along < 50.0; along += 3.7) {
    const Eigen::Array3f before = color_of(colored.walls, along, 2.0, 4);
    const Eigen::Array3f after = color_of(grey.walls, along, 2.0, 4);
    EXPECT_LT(after.maxCoeff() - after.minCoeff(), 2e-3f);
    EXPECT_NEAR(after.x(), 0.299f * before.x() + 0.587f * before.y() + 0.114f * before.z(), 3e-3f);
  }
}

TEST(ProceduralHall, LooksDifferentAfterHalfATurnForEverySeed) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    for (const RoomShape& shape : {RoomShape{}, round_room()}) {
      const Room hall = procedural_hall(seed, shape);
      const double half = 0.5 * wall_perimeter(shape);
      double sum = 0.0;
      int count = 0;
      constexpr int kMeterWide = 6;  // the level whose texels are about a metre
      for (double along = 0.5; along < half; along += 1.0, ++count) {
        const Eigen::Array3f here = color_of(hall.walls, along, 1.6, kMeterWide).sqrt();
        const Eigen::Array3f there = color_of(hall.walls, along + half, 1.6, kMeterWide).sqrt();
        sum += (here - there).abs().maxCoeff();
      }
      EXPECT_GT(sum / count, 0.08) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace reorient

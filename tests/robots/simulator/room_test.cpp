// SPDX-License-Identifier: MIT
#include "robots/simulator/room/room.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/random.h"
#include "robots/simulator/room/room_images.h"

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

RC_GTEST_PROP(RoomShape, HasAWallCoordinateThatRunsOnceAroundABox, ()) {
  const RoomShape shape;
  const double along = *rc::gen::inRange(0, 59200) * 1e-3;
  const Eigen::Vector2d point = wall_point(shape, along);
  const bool on_end = std::abs(std::abs(point.x()) - 8.4) < 1e-9 && std::abs(point.y()) < 6.4 + 1e-9;
  const bool on_side = std::abs(std::abs(point.y()) - 6.4) < 1e-9 && std::abs(point.x()) < 8.4 + 1e-9;
  RC_ASSERT(on_end || on_side);
  RC_ASSERT((wall_point(shape, along + wall_perimeter(shape)) - point).norm() < 1e-6);
  RC_ASSERT((wall_point(shape, along + 1e-4) - point).norm() < 1e-4 + 1e-9);
}

TEST(RoomShape, HasTheOppositePointOfTheWallAtHalfThePerimeter) {
  for (const RoomShape& shape : {RoomShape{}, round_room()}) {
    for (double along = 0.1; along < 20.0; along += 1.3) {
      const Eigen::Vector2d opposite = wall_point(shape, along + 0.5 * wall_perimeter(shape));
      EXPECT_LT((wall_point(shape, along) + opposite).norm(), 1e-9);
    }
  }
}

TEST(RoomShape, OfInvalidSizeIsRefused) {
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

TEST(RoomShape, WithAValueOutsideOfItsRangeIsRefused) {
  const auto refusal = [](const RoomShape& shape) -> std::string {
    try {
      procedural_hall(1, shape);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  };
  for (const double value : {-0.01, 1.01, std::nan(""), std::numeric_limits<double>::infinity()}) {
    RoomShape shape;
    shape.symmetry_strength = value;
    EXPECT_NE(refusal(shape).find("room_shape.symmetry_strength is "), std::string::npos) << value;
    EXPECT_NE(refusal(shape).find("(expected 0 to 1)"), std::string::npos) << value;
  }
  for (const double value : {-0.01, 10.01, std::nan("")}) {
    RoomShape shape;
    shape.mark = value;
    EXPECT_NE(refusal(shape).find("room_shape.mark is "), std::string::npos) << value;
  }
}

TEST(Texture, HasTheSameMeanOnEachLevel) {
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

TEST(Texture, IsContinuousWhereItWrapsAround) {
  LinearImage image(64, 64, LinearColor::Constant(0.5f));
  for (int y = 0; y < image.height; ++y) image.at(63, y) = LinearColor::Ones();
  const Texture texture(image, {}, {1.0, 1.0}, Texture::Edge::wrap);
  EXPECT_NEAR(color_of(texture, 0.0, 0.5, 0).x(), color_of(texture, 1.0, 0.5, 0).x(), 1e-3f);
  EXPECT_NEAR(color_of(texture, 0.0, 0.5, 0).x(), 0.75f, 1e-3f);
}

TEST(Texture, ClampsCoordinatesSlightlyOutside) {
  const Texture texture(LinearImage(64, 64, LinearColor::Constant(0.5f)), {}, {1.0, 1.0}, Texture::Edge::clamp);
  for (const double outside : {-5.0, -1e-6, 1.0 + 1e-6, 7.0}) {
    EXPECT_NEAR(color_of(texture, outside, outside, 0).x(), 0.5f, 1e-3f);
  }
}

TEST(ProceduralHall, DependsOnlyOnTheSeed) {
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

/// Largest difference of a channel between a room and the room rotated by `turns` times 90 degrees.
float difference_after_quarters(const Room& room, int quarters) {
  float greatest = 0.0f;
  for (int side = 0; side < 4; ++side) {
    const int other = (side + quarters) % 4;
    for (double fraction = 0.02; fraction < 1.0; fraction += 0.04) {
      const auto at = [&](int wall) {
        const double begin = wall_begin(room.shape, wall);
        return begin + fraction * (wall_begin(room.shape, wall + 1) - begin);
      };
      for (double height = 0.5; height < 5.0; height += 0.5)
        greatest = std::max(
            greatest,
            (color_of(room.walls, at(side), height, 2) - color_of(room.walls, at(other), height, 2)).abs().maxCoeff());
    }
  }
  return greatest;
}

TEST(SymmetricRoom, LooksTheSameAfterARotationBy180Degrees) {
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

TEST(SymmetricRoom, OfFourEqualWallsLooksAboutTheSameAfterARotationBy90Degrees) {
  RoomShape shape;
  shape.width = shape.length;
  shape.symmetry = RoomSymmetry::four_fold;
  EXPECT_LT(difference_after_quarters(procedural_hall(1, shape), 1), 0.1f);
}

LinearImage random_picture(int width, int height, std::uint64_t seed) {
  Random random(seed, 1);
  LinearImage image(width, height);
  for (LinearColor& color : image.pixels) {
    for (int channel = 0; channel < 3; ++channel) color[channel] = static_cast<float>(random.uniform(0.0, 12.0));
  }
  return image;
}

/// Random pictures that are valid for a room of the default size.
RoomImages random_pictures() {
  return {random_picture(128, 64, 1), random_picture(64, 64, 2), random_picture(64, 64, 3)};
}

RoomImages pictures_at(RoomSymmetry symmetry, double strength) {
  RoomShape shape;
  shape.symmetry = symmetry;
  shape.symmetry_strength = strength;
  RoomImages images = random_pictures();
  make_symmetric(images, shape);
  return images;
}

bool are_equal(const LinearImage& one, const LinearImage& other) {
  return std::equal(one.pixels.begin(), one.pixels.end(), other.pixels.begin(), other.pixels.end(),
                    [](const LinearColor& a, const LinearColor& b) { return (a == b).all(); });
}

TEST(SymmetryStrength, OfOneRepeatsThePicturesExactly) {
  const RoomImages painted = random_pictures();
  const RoomImages symmetric = pictures_at(RoomSymmetry::two_fold, 1.0);
  for (int y = 0; y < painted.walls.height; ++y) {
    for (int x = 0; x < painted.walls.width; ++x)
      ASSERT_TRUE((symmetric.walls.at(x, y) == painted.walls.at(x % (painted.walls.width / 2), y)).all());
  }
  for (const RoomSymmetry symmetry : {RoomSymmetry::two_fold, RoomSymmetry::four_fold}) {
    const RoomImages images = pictures_at(symmetry, 1.0);
    for (const auto& [level, before] : {std::pair(images.ceiling, painted.ceiling), {images.floor, painted.floor}}) {
      const std::size_t count = level.pixels.size();
      for (std::size_t i = 0; i < count; ++i)
        ASSERT_TRUE((level.pixels[i] == before.pixels[std::min(i, count - 1 - i)]).all());
    }
  }
}

TEST(SymmetryStrength, OfOneRepeatsTheFirstWallOnAllFourWalls) {
  const RoomImages painted = random_pictures();
  const RoomImages symmetric = pictures_at(RoomSymmetry::four_fold, 1.0);
  const int first = static_cast<int>(painted.walls.width * wall_begin(RoomShape{}, 1) / wall_perimeter(RoomShape{}));
  for (int x = 0; x < painted.walls.width; ++x) {
    bool is_of_the_first = false;
    for (int from = 0; from <= first; ++from) {
      bool is_equal = true;
      for (int y = 0; y < painted.walls.height; ++y)
        is_equal &= (symmetric.walls.at(x, y) == painted.walls.at(from, y)).all();
      is_of_the_first |= is_equal;
    }
    EXPECT_TRUE(is_of_the_first) << x;
  }
}

TEST(SymmetryStrength, OfZeroDoesNotChangeThePictures) {
  const RoomImages painted = random_pictures();
  for (const RoomSymmetry symmetry : {RoomSymmetry::two_fold, RoomSymmetry::four_fold}) {
    const RoomImages images = pictures_at(symmetry, 0.0);
    EXPECT_TRUE(are_equal(images.walls, painted.walls));
    EXPECT_TRUE(are_equal(images.ceiling, painted.ceiling));
    EXPECT_TRUE(are_equal(images.floor, painted.floor));
  }
}

TEST(SymmetryStrength, BetweenZeroAndOneBlendsInLinearLight) {
  for (const RoomSymmetry symmetry : {RoomSymmetry::two_fold, RoomSymmetry::four_fold}) {
    const RoomImages plain = pictures_at(symmetry, 0.0), symmetric = pictures_at(symmetry, 1.0);
    const RoomImages blended = pictures_at(symmetry, 0.3);
    for (LinearImage RoomImages::*const image : {&RoomImages::walls, &RoomImages::ceiling, &RoomImages::floor}) {
      for (std::size_t i = 0; i < (plain.*image).pixels.size(); ++i) {
        const LinearColor& from = (plain.*image).pixels[i];
        const LinearColor& to = (symmetric.*image).pixels[i];
        ASSERT_LT(((blended.*image).pixels[i] - (0.7f * from + 0.3f * to)).abs().maxCoeff(), 1e-5f);
      }
    }
  }
}

TEST(SymmetryStrength, HasNoEffectInARoomWithoutSymmetry) {
  const RoomImages painted = random_pictures();
  EXPECT_TRUE(are_equal(pictures_at(RoomSymmetry::none, 1.0).walls, painted.walls));
  EXPECT_TRUE(are_equal(pictures_at(RoomSymmetry::none, 1.0).floor, painted.floor));
}

TEST(SymmetryStrength, ReducesTheDifferenceAfterARotationBy180Degrees) {
  RoomShape shape;
  const auto difference = [&](double strength) {
    shape.symmetry_strength = strength;
    return difference_after_quarters(procedural_hall(1, shape), 2);
  };
  const float plain = difference(0.0);
  shape.symmetry = RoomSymmetry::two_fold;
  EXPECT_EQ(difference(0.0), plain);
  EXPECT_LT(difference(0.9), difference(0.5));
  EXPECT_LT(difference(0.5), plain);
  EXPECT_GT(difference(0.9), 0.01f);
}

/// Range in which the wall of a hall with a mark differs from the same hall without: m from the wall's beginning.
struct Marked {
  double first = 1e9, last = -1e9;
};
Marked marked(const RoomShape& shape, int side) {
  RoomShape plain = shape;
  plain.mark = 0.0;
  const Room with = procedural_hall(1, shape), without = procedural_hall(1, plain);
  Marked range;
  const double begin = wall_begin(shape, side), end = wall_begin(shape, side + 1);
  constexpr double kCorner = 0.03;  // m; a sample closer to a corner mixes both walls
  for (double along = begin + kCorner; along < end - kCorner; along += 0.02) {
    for (double height = 0.1; height < shape.height; height += 0.2) {
      if ((color_of(with.walls, along, height, 0) == color_of(without.walls, along, height, 0)).all()) continue;
      EXPECT_GT(height, 0.9);
      EXPECT_LT(height, 2.55);
      range.first = std::min(range.first, along - begin);
      range.last = std::max(range.last, along - begin);
    }
  }
  return range;
}

TEST(Mark, IsOnOnlyOneSideWallAndHasTheWidthThatIsSet) {
  RoomShape shape;
  shape.symmetry = RoomSymmetry::two_fold;
  for (const double width : {6.0, 0.4}) {
    shape.mark = width;
    for (const int side : {0, 1, 2}) EXPECT_LT(marked(shape, side).last, 0.0) << side;
    const Marked range = marked(shape, 3);
    EXPECT_NEAR(range.last - range.first, width, 0.1);
    EXPECT_NEAR(0.5 * (range.first + range.last), 0.5 * shape.length, 0.05);
  }
}

TEST(Mark, IsTheOnlyDifferenceAfterARotationBy180Degrees) {
  RoomShape shape;
  shape.symmetry = RoomSymmetry::two_fold;
  EXPECT_LT(difference_after_quarters(procedural_hall(1, shape), 2), 1e-3f);
  shape.mark = 3.0;
  EXPECT_GT(difference_after_quarters(procedural_hall(1, shape), 2), 0.05f);
}

TEST(Mark, StaysOnItsWallInTheSmallestRoom) {
  RoomShape shape;
  shape.length = shape.width = 4.0;
  shape.height = 2.5;
  shape.mark = kWidestMark;
  for (const int side : {0, 1, 2}) EXPECT_LT(marked(shape, side).last, 0.0) << side;
  EXPECT_GT(marked(shape, 3).last, 3.9);
}

TEST(Mark, LosesItsColorWithTheHall) {
  RoomShape shape;
  shape.mark = 6.0;
  shape.color = 0.0;
  const Room hall = procedural_hall(1, shape);
  for (double along = wall_begin(shape, 3); along < wall_perimeter(shape); along += 0.5) {
    const Eigen::Array3f color = color_of(hall.walls, along, 1.7, 2);
    EXPECT_LT(color.maxCoeff() - color.minCoeff(), 2e-3f);
  }
}

TEST(Mark, IsRefusedForAPanorama) {
  RoomShape shape;
  shape.mark = 0.4;
  try {
    room_from(LinearImage(64, 32, LinearColor::Ones()), "room.hdr", shape);
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "panorama 'room.hdr': room_shape.mark: expected 0, found 0.4 m; only the built-in hall has a banner");
  }
}

TEST(ColorlessRoom, IsGrayAndAsBrightAsBefore) {
  RoomShape shape;
  const Room colored = procedural_hall(1, shape);
  shape.color = 0.0;
  const Room gray = procedural_hall(1, shape);
  for (double along = 0.5; along < 50.0; along += 3.7) {
    const Eigen::Array3f before = color_of(colored.walls, along, 2.0, 4);
    const Eigen::Array3f after = color_of(gray.walls, along, 2.0, 4);
    EXPECT_LT(after.maxCoeff() - after.minCoeff(), 2e-3f);
    EXPECT_NEAR(after.x(), 0.299f * before.x() + 0.587f * before.y() + 0.114f * before.z(), 3e-3f);
  }
}

TEST(ProceduralHall, LooksDifferentAfterARotationBy180DegreesForEachSeed) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    for (const RoomShape& shape : {RoomShape{}, round_room()}) {
      const Room hall = procedural_hall(seed, shape);
      const double half = 0.5 * wall_perimeter(shape);
      double sum = 0.0;
      int count = 0;
      constexpr int kMeterWide = 6;  // the level whose texels are about a meter wide
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

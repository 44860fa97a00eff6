// SPDX-License-Identifier: MIT
#include "robots/simulator/room/room_images.h"

#include <algorithm>
#include <cstddef>

namespace reorient {
namespace {

/// Exact at both ends: bit for bit `repeated` at a strength of 1, `painted` at 0.
LinearColor mixed(const LinearColor& painted, const LinearColor& repeated, float strength) {
  return (1.0f - strength) * painted + strength * repeated;
}

/// At a strength of 1, a rotation by 180 degrees about the center does not change the result.
void make_point_symmetric(LinearImage& level, float strength) {
  const std::size_t count = level.pixels.size();
  for (std::size_t i = 0; i < count / 2; ++i) {
    LinearColor& opposite = level.pixels[count - 1 - i];
    opposite = mixed(opposite, level.pixels[i], strength);
  }
}

/// At a strength of 1, the second half of the perimeter repeats the first half.
void repeat_half(LinearImage& walls, float strength) {
  const int half = walls.width / 2;
  for (int y = 0; y < walls.height; ++y) {
    for (int x = 0; x < half; ++x) walls.at(half + x, y) = mixed(walls.at(half + x, y), walls.at(x, y), strength);
  }
}

/// At a strength of 1, each wall shows the first one, stretched to its own width.
void repeat_first_wall(LinearImage& walls, const RoomShape& shape, float strength) {
  const double columns = walls.width / wall_perimeter(shape);  // in a meter
  const double first = wall_begin(shape, 1) - wall_begin(shape, 0);
  const LinearImage painted = walls;
  for (int side = 1; side < 4; ++side) {
    const double begin = wall_begin(shape, side);
    const double width = wall_begin(shape, side + 1) - begin;
    const int last = side == 3 ? walls.width : static_cast<int>(columns * (begin + width));
    for (int x = static_cast<int>(columns * begin); x < last; ++x) {
      const double fraction = ((x + 0.5) / columns - begin) / width;
      const int from =
          std::clamp(static_cast<int>(fraction * first * columns), 0, static_cast<int>(first * columns) - 1);
      for (int y = 0; y < walls.height; ++y) {
        walls.at(x, y) = mixed(painted.at(x, y), painted.at(from, y), strength);
      }
    }
  }
}

/// Scales the saturation by `fraction`; the brightness stays the same.
void fade(LinearImage& image, float fraction) {
  for (LinearColor& color : image.pixels) {
    const float gray = 0.299f * color.x() + 0.587f * color.y() + 0.114f * color.z();
    color = gray + fraction * (color - gray);
  }
}

}  // namespace

void make_symmetric(RoomImages& images, const RoomShape& shape) {
  if (shape.symmetry == RoomSymmetry::none) return;
  const auto strength = static_cast<float>(shape.symmetry_strength);
  if (shape.symmetry == RoomSymmetry::two_fold) repeat_half(images.walls, strength);
  if (shape.symmetry == RoomSymmetry::four_fold) repeat_first_wall(images.walls, shape, strength);
  make_point_symmetric(images.ceiling, strength);
  make_point_symmetric(images.floor, strength);
}

Room room_of(RoomImages images, const std::string& name, const RoomShape& shape, const LinearColor& light) {
  if (shape.color < 1.0) {
    for (LinearImage* const image : {&images.walls, &images.ceiling, &images.floor})
      fade(*image, static_cast<float>(shape.color));
  }
  Room room;
  room.name = name;
  room.shape = shape;
  room.walls = {images.walls, {}, {wall_perimeter(shape), shape.height}, Texture::Edge::wrap};
  room.ceiling = {images.ceiling, {}, floor_extent(shape), Texture::Edge::clamp};
  room.floor = {images.floor, {}, floor_extent(shape), Texture::Edge::clamp};
  room.light = light;
  return room;
}

}  // namespace reorient

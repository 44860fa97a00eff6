// SPDX-License-Identifier: MIT
#include "robots/simulator/render/light/wall_patches.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/wide.h"
#include "robots/simulator/render/coverage.h"
#include "robots/simulator/room/texture_painter.h"

namespace reorient {
namespace {

enum class PatchKind : std::uint8_t { banner, door, projection, curtain };

struct PatchSize {
  double width, height, bottom;  // m
};

PatchSize size_of(PatchKind kind, double reach, Random& random) {
  switch (kind) {
    case PatchKind::banner: {
      const double height = random.uniform(0.6, 1.1);
      return {random.uniform(2.0, 4.5), height, random.uniform(0.2, reach - height)};
    }
    case PatchKind::door:
      return {random.uniform(1.0, 2.0), 2.1, 0.0};
    case PatchKind::projection: {
      const double height = random.uniform(1.3, 1.6);
      return {4.0 / 3.0 * height, height, random.uniform(0.8, reach - height)};
    }
    case PatchKind::curtain:
      return {random.uniform(1.2, 3.5), random.uniform(1.8, reach), 0.0};
  }
  return {1.0, 1.0, 0.0};
}

bool round_a_corner(const RoomShape& shape, double left, double right) {
  if (shape.form == RoomForm::cylinder) return false;
  for (int side = 1; side < 4; ++side) {
    const double corner = wall_begin(shape, side);
    if (left < corner && corner < right) return true;
  }
  return false;
}

/// The part of the wall that a row of pixels shows.
struct RowRange {
  float low_u = 1e9f, high_u = -1e9f, low_v = 1e9f, high_v = -1e9f;
};

RowRange range_of(const WallRow& row) {
  RowRange range;
  for (int i = 0; i < row.count; ++i) {
    if (row.on_wall[i] == 0.0f) continue;
    const float half = 0.5f * row.footprint[i];
    range.low_u = std::min(range.low_u, row.u[i] - half);
    range.high_u = std::max(range.high_u, row.u[i] + half);
    range.low_v = std::min(range.low_v, row.v[i] - half);
    range.high_v = std::max(range.high_v, row.v[i] + half);
  }
  return range;
}

}  // namespace

WallPatches::WallPatches(double fraction, double reach, const Room& room, Random& random) {
  constexpr int kTries = 3000;
  constexpr double kApart = 0.05;  // m
  const RoomShape& shape = room.shape;
  const double height = std::min(reach, shape.height);
  const bool repeated = shape.symmetry != RoomSymmetry::none;
  const double perimeter = (repeated ? 0.5 : 1.0) * wall_perimeter(shape);
  const double requested = fraction * perimeter * height;
  std::vector<Rectangle> outlines;
  for (int attempt = 0; attempt < kTries && area_ < requested * (1.0 - 1e-9); ++attempt) {
    const auto kind = static_cast<PatchKind>(random.below(4));
    PatchSize size = size_of(kind, height, random);
    size.width = std::min(size.width, (requested - area_) / size.height);  // the last one fills the rest
    const double left = random.uniform(0.0, perimeter - size.width);
    const double right = left + size.width;
    const double top = size.bottom + size.height;
    const bool taken = std::any_of(outlines.begin(), outlines.end(), [&](const Rectangle& other) {
      return left < other.right + kApart && right > other.left - kApart && size.bottom < other.top + kApart &&
             top > other.bottom - kApart;
    });
    if (taken || round_a_corner(shape, left, right)) continue;
    outlines.push_back({static_cast<float>(left), static_cast<float>(right), static_cast<float>(size.bottom),
                        static_cast<float>(top), LinearColor::Zero()});
    area_ += size.width * size.height;
    switch (kind) {
      case PatchKind::banner:
        add_banner(outlines.back(), room.light, random);
        break;
      case PatchKind::door:
        add_door(outlines.back(), room.light, random);
        break;
      case PatchKind::projection:
        add_projection(outlines.back(), random);
        break;
      case PatchKind::curtain:
        add_curtain(outlines.back(), room.light, random);
        break;
    }
  }
  if (repeated) repeat(perimeter);
}

void WallPatches::repeat(double shift) {
  const std::size_t count = rectangles_.size();
  rectangles_.reserve(2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    Rectangle copy = rectangles_[i];
    copy.left += static_cast<float>(shift);
    copy.right += static_cast<float>(shift);
    rectangles_.push_back(copy);
  }
  area_ *= 2.0;
}

void WallPatches::add(double left, double bottom, double width, double height, const LinearColor& color) {
  rectangles_.push_back({static_cast<float>(left), static_cast<float>(left + width), static_cast<float>(bottom),
                         static_cast<float>(bottom + height), color});
}

void WallPatches::add_banner(const Rectangle& outline, const LinearColor& light, Random& random) {
  const double hue = random.uniform();
  const double width = outline.right - outline.left;
  const double height = outline.top - outline.bottom;
  const bool pale = random.uniform() < 0.4;
  const LinearColor ground = paint_of(hue, pale ? 0.1 : 0.75, pale ? 0.75 : 0.5) * light;
  const LinearColor sign = paint_of(hue + 0.5, pale ? 0.7 : 0.1, pale ? 0.45 : 0.75) * light;
  add(outline.left, outline.bottom, width, height, ground);
  const double letter = 0.3 * height;
  for (double x = 0.15; x + letter < width - 0.1; x += 1.5 * letter) {
    if (random.uniform() < 0.2) continue;  // between words
    add(outline.left + x, outline.bottom + 0.3 * height, random.uniform(0.4, 1.0) * letter, 0.42 * height, sign);
  }
}

void WallPatches::add_door(const Rectangle& outline, const LinearColor& light, Random& random) {
  constexpr double kFrame = 0.08;  // m
  const double width = outline.right - outline.left;
  const double height = outline.top - outline.bottom;
  add(outline.left, outline.bottom, width, height, paint_of(random.uniform(), 0.4, 0.35) * light);
  // An open door to a dark corridor or to the bright outside.
  const double beyond = random.uniform() < 0.5 ? random.uniform(0.05, 0.2) : random.uniform(0.7, 1.0);
  if (width > 3.0 * kFrame) {
    add(outline.left + kFrame, outline.bottom, width - 2.0 * kFrame, height - kFrame,
        paint_of(random.uniform(), 0.15, beyond) * light);
  }
}

void WallPatches::add_projection(const Rectangle& outline, Random& random) {
  constexpr float kBright = 0.55f;  // a projector has its own light
  const double hue = random.uniform();
  const double width = outline.right - outline.left;
  const double height = outline.top - outline.bottom;
  add(outline.left, outline.bottom, width, height, kBright * paint_of(hue, 0.2, 0.95));
  add(outline.left, outline.bottom + 0.8 * height, width, 0.2 * height, kBright * paint_of(hue, 0.9, 0.6));
  constexpr int kBars = 5;
  for (int i = 0; i < kBars; ++i) {
    add(outline.left + (0.1 + 0.17 * i) * width, outline.bottom + 0.1 * height, 0.1 * width,
        random.uniform(0.1, 0.6) * height, kBright * paint_of(hue + 0.2 * (i + 1), 0.8, 0.8));
  }
}

void WallPatches::add_curtain(const Rectangle& outline, const LinearColor& light, Random& random) {
  constexpr double kFold = 0.34;  // m
  const double width = outline.right - outline.left;
  const double height = outline.top - outline.bottom;
  const LinearColor cloth = any_paint(Range{}, {0.2, 0.75}, {0.2, 0.55}, random) * light;
  add(outline.left, outline.bottom, width, height, cloth);
  for (double x = 0.2; x < width; x += kFold) {
    add(outline.left + x, outline.bottom, std::min(0.12, width - x), height,
        static_cast<float>(random.uniform(0.4, 0.7)) * cloth);
  }
}

REORIENT_WIDE void WallPatches::paint(const WallRow& row, float* __restrict red, float* __restrict green,
                                      float* __restrict blue) const {
  const RowRange range = range_of(row);
  const float* __restrict u = row.u;
  const float* __restrict v = row.v;
  const float* __restrict footprint = row.footprint;
  const float* __restrict on_wall = row.on_wall;
  for (const Rectangle& patch : rectangles_) {
    if (patch.left > range.high_u || patch.right < range.low_u || patch.bottom > range.high_v ||
        patch.top < range.low_v) {
      continue;
    }
    const float patch_red = patch.color.x();
    const float patch_green = patch.color.y();
    const float patch_blue = patch.color.z();
    for (int i = 0; i < row.count; ++i) {
      const float half = 0.5f * footprint[i] + 1e-6f;
      const float coverage = on_wall[i] * covered_fraction(u[i], half, patch.left, patch.right) *
                             covered_fraction(v[i], half, patch.bottom, patch.top);
      red[i] += coverage * (patch_red - red[i]);
      green[i] += coverage * (patch_green - green[i]);
      blue[i] += coverage * (patch_blue - blue[i]);
    }
  }
}

}  // namespace reorient

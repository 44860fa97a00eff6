// SPDX-License-Identifier: MIT
// New things on the walls: banners, doors, curtains, a projector's picture. They are rectangles in front of the wall's
// texture, so that the room need not be painted again. Their edges are as soft as the pixels are large.
#pragma once

#include <vector>

#include "geometry/random.h"
#include "robots/simulator/room/room.h"

namespace reorient {

/// A row of pixels, some of which show the wall. All arrays have `count` values.
struct WallRow {
  const float* u = nullptr;          ///< m, along the wall (room.h)
  const float* v = nullptr;          ///< m above the floor
  const float* footprint = nullptr;  ///< m of the wall that a pixel spans
  const float* on_wall = nullptr;    ///< 1 if the pixel shows the wall, else 0
  int count = 0;
};

class WallPatches {
 public:
  WallPatches() = default;

  /// Patches that cover `fraction` of the wall between the floor and a height of `reach` meters, in the light
  /// of `room`. They cover less only if there is no space. In a symmetric room the patches are symmetric, too.
  WallPatches(double fraction, double reach, const Room& room, Random& random);

  bool empty() const { return rectangles_.empty(); }
  /// Area of the wall that they cover, m^2.
  double area() const { return area_; }

  /// Paints over red, green and blue, `row.count` values each.
  void paint(const WallRow& row, float* red, float* green, float* blue) const;

 private:
  struct Rectangle {
    float left, right, bottom, top;
    LinearColor color;
  };

  void repeat(double shift);
  void add(double left, double bottom, double width, double height, const LinearColor& color);
  void add_banner(const Rectangle& outline, const LinearColor& light, Random& random);
  void add_door(const Rectangle& outline, const LinearColor& light, Random& random);
  void add_projection(const Rectangle& outline, Random& random);
  void add_curtain(const Rectangle& outline, const LinearColor& light, Random& random);

  std::vector<Rectangle> rectangles_;  // in the order in which they are painted
  double area_ = 0.0;
};

}  // namespace reorient

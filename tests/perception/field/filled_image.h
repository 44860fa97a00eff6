// SPDX-License-Identifier: MIT
// Images, or parts of images, with one color.
#pragma once

#include <algorithm>
#include <cstdint>

#include "geometry/image.h"

namespace reorient {

/// Fills the part of the rectangle inside of the image, excluding the right and bottom pixels. `left` and `right` are
/// rounded down to even numbers.
inline void fill(Image& image, int left, int top, int right, int bottom, const Ycbcr& color) {
  for (int y = std::max(top, 0); y < std::min(bottom, image.height()); ++y) {
    for (int x = std::max(left, 0) & ~1; x < std::min(right, image.width()); x += 2) {
      std::uint8_t* pair = image.row(y) + 2 * x;
      pair[0] = pair[2] = color.y;
      pair[1] = color.cb;
      pair[3] = color.cr;
    }
  }
}

inline Image filled(int width, int height, const Ycbcr& color) {
  Image image(width, height);
  fill(image, 0, 0, width, height, color);
  return image;
}

}  // namespace reorient

// An image of one color.
#pragma once

#include "geometry/image.h"

namespace reorient {

inline Image filled(int width, int height, const Ycbcr& color) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; x += 2) {
      std::uint8_t* pair = image.row(y) + 2 * x;
      pair[0] = pair[2] = color.y;
      pair[1] = color.cb;
      pair[3] = color.cr;
    }
  }
  return image;
}

}  // namespace reorient

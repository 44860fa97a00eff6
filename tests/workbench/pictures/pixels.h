// SPDX-License-Identifier: MIT
// Functions of tests on the pixels of a picture.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "workbench/views/pictures/canvas/picture.h"

namespace reorient::pictures {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline bool is_similar(const Color& a, const Color& b, int tolerance = 12) {
  return std::abs(a.red - b.red) <= tolerance && std::abs(a.green - b.green) <= tolerance &&
         std::abs(a.blue - b.blue) <= tolerance;
}

/// Number of pixels with this color in a part of the picture; positions outside of the picture do not count.
inline int count(const Picture& picture, const Color& color, int left, int top, int right, int bottom) {
  int found = 0;
  for (int y = std::max(top, 0); y < std::min(bottom, picture.height); ++y)
    for (int x = std::max(left, 0); x < std::min(right, picture.width); ++x)
      if (is_similar(picture.at(x, y), color)) ++found;
  return found;
}

inline int count(const Picture& picture, const Color& color) {
  return count(picture, color, 0, 0, picture.width, picture.height);
}

}  // namespace reorient::pictures

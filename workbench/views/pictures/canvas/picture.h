// SPDX-License-Identifier: MIT
// A finished picture as bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "workbench/views/scene/color.h"

namespace reorient::pictures {

using scene::Color;
namespace palette = scene::palette;

/// Rows from top to bottom, three bytes for each pixel: red, green, blue (sRGB).
struct Picture {
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels
  std::vector<std::uint8_t> bytes;

  /// Pixel (x, y) must be inside the picture.
  Color at(int x, int y) const {
    const std::uint8_t* pixel =
        &bytes[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
    return {pixel[0], pixel[1], pixel[2]};
  }
  bool operator==(const Picture&) const = default;
};

}  // namespace reorient::pictures

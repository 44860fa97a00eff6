// A finished picture: plain bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace reorient::pictures {

struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  double opacity = 1.0;  ///< what of it covers what is beneath: 0 nothing, 1 all

  constexpr Color with_opacity(double new_opacity) const { return {red, green, blue, new_opacity}; }
  bool operator==(const Color&) const = default;
};

/// Rows from top to bottom, three bytes a pixel: red, green, blue (sRGB).
struct Picture {
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels
  std::vector<std::uint8_t> bytes;

  /// Pixel (x, y) has to lie inside of the picture.
  Color at(int x, int y) const {
    const std::uint8_t* pixel =
        &bytes[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
    return {pixel[0], pixel[1], pixel[2]};
  }
  bool operator==(const Picture&) const = default;
};

}  // namespace reorient::pictures

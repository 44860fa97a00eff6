// SPDX-License-Identifier: MIT
// What a camera sees while the head turns fast: motion blur, the noise of dim light, and the skew of a rolling shutter.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "geometry/image.h"
#include "geometry/random.h"

namespace reorient {

/// Each pixel becomes the mean of `blur` pixels in its row, and its luma gets noise of up to `noise`.
inline Image seen_while_turning(const Image& still, int blur, double noise) {
  Random random(1);
  const ImageView view = still.view();
  Image image(view.width, view.height);
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      int luma = 0, blue = 0, red = 0;
      for (int i = 0; i < blur; ++i) {
        const Ycbcr color = view.at(std::clamp(x + i - blur / 2, 0, view.width - 1), y);
        luma += color.y;
        blue += color.cb;
        red += color.cr;
      }
      std::uint8_t* const pair = image.row(y) + 4 * static_cast<std::ptrdiff_t>(x / 2);
      const double noisy = static_cast<double>(luma) / blur + random.uniform(-noise, noise);
      pair[2 * (x % 2)] = static_cast<std::uint8_t>(std::clamp(noisy, 0.0, 255.0));
      pair[1] = static_cast<std::uint8_t>(blue / blur);
      pair[3] = static_cast<std::uint8_t>(red / blur);
    }
  }
  return image;
}

/// Each row is shifted, the last one by `skew` pixels to the left against the first one. The middle row stays.
inline Image seen_by_rolling_shutter(const Image& still, double skew) {
  const ImageView view = still.view();
  Image image(view.width, view.height);
  for (int y = 0; y < view.height; ++y) {
    const int shift = 2 * static_cast<int>(std::lround(0.5 * skew * (y / (view.height - 1.0) - 0.5)));  // whole pairs
    for (int x = 0; x < view.width; x += 2) {
      const Ycbcr left = view.at(std::clamp(x + shift, 0, view.width - 2), y);
      const Ycbcr right = view.at(std::clamp(x + 1 + shift, 1, view.width - 1), y);
      std::uint8_t* const pair = image.row(y) + 2 * static_cast<std::ptrdiff_t>(x);
      pair[0] = left.y;
      pair[1] = left.cb;
      pair[2] = right.y;
      pair[3] = left.cr;
    }
  }
  return image;
}

}  // namespace reorient

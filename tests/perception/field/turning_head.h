// SPDX-License-Identifier: MIT
// What a camera sees while the head turns fast: motion blur, and the noise of dim light.
#pragma once

#include <algorithm>
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

}  // namespace reorient

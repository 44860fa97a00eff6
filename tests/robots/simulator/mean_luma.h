// SPDX-License-Identifier: MIT
// Mean brightness of an image.
#pragma once

#include "geometry/image.h"

namespace reorient {

inline double mean_luma(const ImageView& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) sum += image.luma(x, y);
  }
  return sum / (image.width * image.height);
}

}  // namespace reorient

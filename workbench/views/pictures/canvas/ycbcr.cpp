// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/canvas/ycbcr.h"

namespace reorient::pictures {

Picture to_picture(const ImageView& image) {
  if (image.empty()) return {};
  Picture picture{image.width, image.height, {}};
  picture.bytes.reserve(3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Color color = to_color(image.at(x, y));
      picture.bytes.insert(picture.bytes.end(), {color.red, color.green, color.blue});
    }
  }
  return picture;
}

}  // namespace reorient::pictures

#include "workbench/views/pictures/canvas/ycbcr.h"

#include <algorithm>
#include <cmath>

namespace reorient::pictures {

Color to_color(Ycbcr color) {
  const double cb = color.cb - 128.0;
  const double cr = color.cr - 128.0;
  const auto byte = [](double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))); };
  return {byte(color.y + 1.402 * cr), byte(color.y - 0.344136 * cb - 0.714136 * cr), byte(color.y + 1.772 * cb)};
}

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

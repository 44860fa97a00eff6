// SPDX-License-Identifier: MIT
#include "tests/perception/field/picture_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <png.h>

namespace reorient {
namespace {

std::uint8_t to_byte(double value) { return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L)); }

struct Rgb {
  double r, g, b;
  Rgb(const std::uint8_t* p) : r(p[0]), g(p[1]), b(p[2]) {}
  double y() const { return 0.299 * r + 0.587 * g + 0.114 * b; }
  double cb() const { return 128.0 + 0.564 * (b - y()); }
  double cr() const { return 128.0 + 0.713 * (r - y()); }
};

}  // namespace

Image read_png(const std::filesystem::path& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&png, file.c_str()) == 0)
    throw std::runtime_error(file.string() + ": not a valid PNG file");
  png.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(png));
  if (png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr) == 0) {
    throw std::runtime_error(file.string() + ": damaged PNG file");
  }
  Image image(static_cast<int>(png.width) / 2 * 2, static_cast<int>(png.height));
  for (int y = 0; y < image.height(); ++y) {
    std::uint8_t* out = image.row(y);
    for (int x = 0; x < image.width(); x += 2, out += 4) {
      const std::uint8_t* in =
          bytes.data() + 3 * (static_cast<std::size_t>(y) * png.width + static_cast<std::size_t>(x));
      const Rgb first(in);
      const Rgb second(in + 3);
      out[0] = to_byte(first.y());
      out[1] = to_byte(0.5 * (first.cb() + second.cb()));
      out[2] = to_byte(second.y());
      out[3] = to_byte(0.5 * (first.cr() + second.cr()));
    }
  }
  return image;
}

Image read_yuyv(const std::filesystem::path& file, int width, int height, std::size_t header) {
  std::ifstream in(file, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(header));
  Image image(width, height);
  for (int y = 0; y < height; ++y) in.read(reinterpret_cast<char*>(image.row(y)), std::streamsize{2} * width);
  if (!in) throw std::runtime_error(file.string() + ": truncated");
  return image;
}

Image halved(const ImageView& image) {
  Image half(image.width / 4 * 2, image.height / 2);
  for (int y = 0; y < half.height(); ++y) {
    std::uint8_t* out = half.row(y);
    for (int x = 0; x < half.width(); x += 2, out += 4) {
      const Ycbcr left = image.at(2 * x, 2 * y);
      const Ycbcr right = image.at(2 * x + 2, 2 * y);
      out[0] = left.y;
      out[1] = left.cb;
      out[2] = right.y;
      out[3] = right.cr;
    }
  }
  return half;
}

}  // namespace reorient

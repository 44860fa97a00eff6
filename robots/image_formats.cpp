#include "robots/image_formats.h"

#include <algorithm>
#include <cstring>

namespace reorient {
namespace {

std::uint8_t byte_of(int value) { return static_cast<std::uint8_t>(std::clamp(value, 0, 255)); }

// In 1/65536, rounded.
int luma_of(int red, int green, int blue) { return (19595 * red + 38470 * green + 7471 * blue + 32768) >> 16; }
int cb_of(int red, int green, int blue) { return 128 + ((-11059 * red - 21709 * green + 32768 * blue + 32768) >> 16); }
int cr_of(int red, int green, int blue) { return 128 + ((32768 * red - 27439 * green - 5329 * blue + 32768) >> 16); }

/// `red`, `blue`: their offsets in a pixel of three bytes.
void convert_rgb(const std::uint8_t* from, std::size_t red, std::size_t blue, Image& image) {
  for (int y = 0; y < image.height(); ++y) {
    std::uint8_t* to = image.row(y);
    for (int x = 0; x < image.width(); x += 2, from += 6, to += 4) {
      // Both pixels of a pair share the chroma of their mean.
      const int r = (from[red] + from[3 + red] + 1) / 2;
      const int g = (from[1] + from[4] + 1) / 2;
      const int b = (from[blue] + from[3 + blue] + 1) / 2;
      to[0] = byte_of(luma_of(from[red], from[1], from[blue]));
      to[1] = byte_of(cb_of(r, g, b));
      to[2] = byte_of(luma_of(from[3 + red], from[4], from[3 + blue]));
      to[3] = byte_of(cr_of(r, g, b));
    }
  }
}

/// Each row of chroma pairs belongs to two rows of luma.
void convert_nv12(const std::uint8_t* luma, Image& image) {
  const auto width = static_cast<std::size_t>(image.width());
  const std::uint8_t* const chroma = luma + width * static_cast<std::size_t>(image.height());
  for (int y = 0; y < image.height(); ++y, luma += width) {
    const std::uint8_t* const pairs = chroma + width * static_cast<std::size_t>(y / 2);
    std::uint8_t* const to = image.row(y);
    for (std::size_t x = 0; x < width; x += 2) {
      to[2 * x] = luma[x];
      to[2 * x + 1] = pairs[x];
      to[2 * x + 2] = luma[x + 1];
      to[2 * x + 3] = pairs[x + 1];
    }
  }
}

void convert_gray(const std::uint8_t* from, Image& image) {
  constexpr std::uint8_t kNoColor = 128;
  for (int y = 0; y < image.height(); ++y) {
    std::uint8_t* to = image.row(y);
    for (int x = 0; x < image.width(); ++x, to += 2) {
      to[0] = *from++;
      to[1] = kNoColor;
    }
  }
}

}  // namespace

void convert_image(std::span<const std::uint8_t> bytes, PixelFormat format, Image& image) {
  switch (format) {
    case PixelFormat::yuyv: {
      const std::size_t row = 2 * static_cast<std::size_t>(image.width());
      for (int y = 0; y < image.height(); ++y)
        std::memcpy(image.row(y), bytes.data() + static_cast<std::size_t>(y) * row, row);
      return;
    }
    case PixelFormat::nv12:
      return convert_nv12(bytes.data(), image);
    case PixelFormat::rgb:
      return convert_rgb(bytes.data(), 0, 2, image);
    case PixelFormat::bgr:
      return convert_rgb(bytes.data(), 2, 0, image);
    case PixelFormat::gray:
      return convert_gray(bytes.data(), image);
  }
}

}  // namespace reorient

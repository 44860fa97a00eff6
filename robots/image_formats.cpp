// SPDX-License-Identifier: MIT
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

/// `Pixel`: bytes per pixel. `Red`, `Blue`: offsets of these values in a pixel.
template <std::size_t Pixel, std::size_t Red, std::size_t Blue>
void convert_row(const std::uint8_t* from, std::uint8_t* to, int width) {
  for (int x = 0; x < width; x += 2, from += 2 * Pixel, to += 4) {
    const std::uint8_t* const next = from + Pixel;
    // The two pixels of a pair have the same chroma, computed from their mean.
    const int r = (from[Red] + next[Red] + 1) / 2;
    const int g = (from[1] + next[1] + 1) / 2;
    const int b = (from[Blue] + next[Blue] + 1) / 2;
    to[0] = byte_of(luma_of(from[Red], from[1], from[Blue]));
    to[1] = byte_of(cb_of(r, g, b));
    to[2] = byte_of(luma_of(next[Red], next[1], next[Blue]));
    to[3] = byte_of(cr_of(r, g, b));
  }
}

void copy_row(const std::uint8_t* from, std::uint8_t* to, int width) {
  std::memcpy(to, from, 2 * static_cast<std::size_t>(width));
}

void swap_row(const std::uint8_t* from, std::uint8_t* to, int width) {
  for (int x = 0; x < width; ++x, from += 2, to += 2) {
    to[0] = from[1];
    to[1] = from[0];
  }
}

void convert_gray_row(const std::uint8_t* from, std::uint8_t* to, int width) {
  constexpr std::uint8_t kNoColor = 128;
  for (int x = 0; x < width; ++x, to += 2) {
    to[0] = *from++;
    to[1] = kNoColor;
  }
}

/// Each row of chroma pairs belongs to two rows of luma.
void convert_nv12(const std::uint8_t* luma, std::size_t stride, Image& image) {
  const auto width = static_cast<std::size_t>(image.width());
  const std::uint8_t* const chroma = luma + stride * static_cast<std::size_t>(image.height());
  for (int y = 0; y < image.height(); ++y, luma += stride) {
    const std::uint8_t* const pairs = chroma + stride * static_cast<std::size_t>(y / 2);
    std::uint8_t* const to = image.row(y);
    for (std::size_t x = 0; x < width; x += 2) {
      to[2 * x] = luma[x];
      to[2 * x + 1] = pairs[x];
      to[2 * x + 2] = luma[x + 1];
      to[2 * x + 3] = pairs[x + 1];
    }
  }
}

}  // namespace

std::size_t row_bytes(PixelFormat format, int width) {
  const auto pixels = static_cast<std::size_t>(width);
  switch (format) {
    case PixelFormat::yuyv:
    case PixelFormat::uyvy:
      return 4 * ((pixels + 1) / 2);
    case PixelFormat::nv12:
    case PixelFormat::gray:
      return pixels;
    case PixelFormat::rgb:
    case PixelFormat::bgr:
      return 3 * pixels;
    case PixelFormat::rgba:
    case PixelFormat::bgra:
      return 4 * pixels;
  }
  return 0;
}

std::size_t image_bytes(PixelFormat format, int width, int height, std::size_t stride) {
  if (height <= 0) return 0;
  const auto rows = static_cast<std::size_t>(height);
  const std::size_t all_rows = format == PixelFormat::nv12 ? rows + (rows + 1) / 2 : rows;
  return (all_rows - 1) * stride + row_bytes(format, width);
}

void convert_image(std::span<const std::uint8_t> bytes, PixelFormat format, std::size_t stride, Image& image) {
  if (format == PixelFormat::nv12) return convert_nv12(bytes.data(), stride, image);
  const auto each_row = [&](auto convert) {
    for (int y = 0; y < image.height(); ++y)
      convert(bytes.data() + static_cast<std::size_t>(y) * stride, image.row(y), image.width());
  };
  switch (format) {
    case PixelFormat::yuyv:
      return each_row(copy_row);
    case PixelFormat::uyvy:
      return each_row(swap_row);
    case PixelFormat::rgb:
      return each_row(convert_row<3, 0, 2>);
    case PixelFormat::bgr:
      return each_row(convert_row<3, 2, 0>);
    case PixelFormat::rgba:
      return each_row(convert_row<4, 0, 2>);
    case PixelFormat::bgra:
      return each_row(convert_row<4, 2, 0>);
    case PixelFormat::gray:
    case PixelFormat::nv12:
      return each_row(convert_gray_row);
  }
}

void convert_image(std::span<const std::uint8_t> bytes, PixelFormat format, Image& image) {
  convert_image(bytes, format, row_bytes(format, image.width()), image);
}

}  // namespace reorient

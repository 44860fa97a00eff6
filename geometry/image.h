// SPDX-License-Identifier: MIT
// Camera images in the format of a NAO: YCbCr 4:2:2, in memory Y0 Cb Y1 Cr (YUYV of V4L2), full range, BT.601.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace reorient {

struct Ycbcr {
  std::uint8_t y = 0;
  std::uint8_t cb = 128;
  std::uint8_t cr = 128;
  bool operator==(const Ycbcr&) const = default;
};

/// Widths that are possible for simulated images, pixels: those of the shipped bodies' cameras and fractions of them.
inline constexpr std::array kImageWidths = {160, 320, 544, 640};

/// A view of an image that another object owns. Valid as long as the owner exists.
struct ImageView {
  const std::uint8_t* data = nullptr;
  int width = 0;   ///< pixels, even
  int height = 0;  ///< pixels
  int stride = 0;  ///< bytes from one row to the next, at least 2 * width

  bool empty() const { return data == nullptr || width <= 0 || height <= 0; }
  const std::uint8_t* row(int y) const { return data + static_cast<std::ptrdiff_t>(y) * stride; }
  std::uint8_t luma(int x, int y) const { return row(y)[2 * x]; }
  Ycbcr at(int x, int y) const {
    const std::uint8_t* pair = row(y) + 4 * (x / 2);
    return {pair[2 * (x % 2)], pair[1], pair[3]};
  }
};

/// An image that owns its memory.
class Image {
 public:
  Image() = default;
  Image(int width, int height)
      : width_(width),
        height_(height),
        bytes_(static_cast<std::size_t>(2 * width) * static_cast<std::size_t>(height)) {}

  int width() const { return width_; }
  int height() const { return height_; }
  std::uint8_t* row(int y) { return bytes_.data() + static_cast<std::ptrdiff_t>(y) * 2 * width_; }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  ImageView view() const { return {bytes_.data(), width_, height_, 2 * width_}; }

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace reorient

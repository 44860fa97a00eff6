// SPDX-License-Identifier: MIT
// Converts pixel formats of other programs to Reorient's format (geometry/image.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/image.h"

namespace reorient {

enum class PixelFormat {
  yuyv,  ///< 2 pixels in 4 bytes: Y0 Cb Y1 Cr
  uyvy,  ///< 2 pixels in 4 bytes: Cb Y0 Cr Y1
  nv12,  ///< a plane of Y, then rows of pairs Cb Cr, each for 2 x 2 pixels
  rgb,   ///< 3 bytes per pixel
  bgr,   ///< 3 bytes per pixel
  rgba,  ///< 4 bytes per pixel; the last is ignored
  bgra,  ///< 4 bytes per pixel; the last is ignored
  gray,  ///< 1 byte per pixel
};

/// Bytes of one row without padding; for NV12, of one row of Y.
std::size_t row_bytes(PixelFormat format, int width);
/// Bytes from the first pixel to the last. `stride`: bytes from one row to the next, at least row_bytes().
std::size_t image_bytes(PixelFormat format, int width, int height, std::size_t stride);

/// Converts `bytes` to `image`, whose width is even; `stride` as above. RGB becomes YCbCr by BT.601, full range; YCbCr
/// values are copied.
void convert_image(std::span<const std::uint8_t> bytes, PixelFormat format, std::size_t stride, Image& image);
/// The same for rows without padding.
void convert_image(std::span<const std::uint8_t> bytes, PixelFormat format, Image& image);

}  // namespace reorient

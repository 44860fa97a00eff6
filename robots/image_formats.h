// Pixel formats of other programs, converted to ours (geometry/image.h).
#pragma once

#include <cstdint>
#include <span>

#include "geometry/image.h"

namespace reorient {

enum class PixelFormat {
  yuyv,  ///< 2 pixels in 4 bytes: Y0 Cb Y1 Cr
  nv12,  ///< a plane of Y, then rows of pairs Cb Cr, each for 2 x 2 pixels
  rgb,   ///< 3 bytes a pixel
  bgr,   ///< 3 bytes a pixel
  gray,  ///< 1 byte a pixel
};

/// Converts `bytes`, rows without padding, to `image`, whose width and height are even. RGB becomes YCbCr by BT.601,
/// full range; the YCbCr values of NV12 are copied.
void convert_image(std::span<const std::uint8_t> bytes, PixelFormat format, Image& image);

}  // namespace reorient

// An image so that a general compression finds little left to say of it: luma, Cb and Cr each on their own, each value
// less its left neighbour. On cameras' noise that halves what zstd makes of the pixels as they come.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/image.h"

namespace reorient {

struct UnpackedImage {
  std::vector<std::uint8_t> yuyv;
  int width = 0, height = 0;  ///< pixels
};

/// Appends it.
void pack_image(const ImageView& image, std::vector<std::byte>& bytes);

/// The same pixels. Throws BadBytes.
UnpackedImage unpack_image(std::span<const std::byte> bytes);

}  // namespace reorient

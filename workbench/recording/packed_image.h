// SPDX-License-Identifier: MIT
// An image prepared for a general compression: luma, Cb and Cr each on their own, each value
// less its left neighbor. On cameras' noise that halves what zstd makes of the pixels as they come.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/image.h"

namespace reorient {

/// Appends it.
void pack_image(const ImageView& image, std::vector<std::byte>& bytes);

/// The same pixels; `image` keeps its memory where it has that size. Throws BadBytes.
void unpack_image(std::span<const std::byte> bytes, Image& image);

}  // namespace reorient

// Images as other programs have them, turned into ours (geometry/image.h) while they are copied.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/image.h"

namespace reorient {

/// Bytes of an image in a format of the protocol (REORIENT_YUYV ...); 0: there is no such format.
std::size_t bytes_of_image(int width, int height, std::uint32_t format);

/// `bytes` must hold the image, `image` have its size; both numbers are even. Colours by BT.601, full range; of NV12 as
/// they are.
void convert_image(std::span<const std::uint8_t> bytes, std::uint32_t format, Image& image);

}  // namespace reorient

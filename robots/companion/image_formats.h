// Images as other programs have them, turned into ours (geometry/image.h) while they are copied.
#pragma once

#include <cstdint>
#include <span>

#include "geometry/image.h"

namespace reorient {

/// `bytes` must hold the image in a format of the protocol (REORIENT_YUYV ...), `image` have its size; both numbers are
/// even. Colours by BT.601, full range; of NV12 as they are.
void convert_image(std::span<const std::uint8_t> bytes, std::uint32_t format, Image& image);

}  // namespace reorient

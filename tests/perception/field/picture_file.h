// SPDX-License-Identifier: MIT
// Picture files for tests: reads and writes PNG, reads raw YUYV. They throw on any error.
#pragma once

#include <filesystem>

#include "geometry/image.h"

namespace reorient {

/// An RGB picture converted to the format of a camera (full range BT.601). The width is reduced to an even number.
Image read_png(const std::filesystem::path& file);

/// `header` bytes, then rows of 2 * width bytes.
Image read_yuyv(const std::filesystem::path& file, int width, int height, std::size_t header);

/// Every second pixel of every second row.
Image halved(const ImageView& image);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Picture files for tests: PNG in and out, and a raw YUYV dump. For tests alone: they throw on any trouble.
#pragma once

#include <filesystem>

#include "geometry/image.h"

namespace reorient {

/// An RGB picture as a camera would have delivered it (full range BT.601); the width is cut to an even number.
Image read_png(const std::filesystem::path& file);

/// `header` bytes, then rows of 2 * width bytes.
Image read_yuyv(const std::filesystem::path& file, int width, int height, std::size_t header);

/// Every second pixel of every second row.
Image halved(const ImageView& image);

}  // namespace reorient

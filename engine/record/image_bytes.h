// SPDX-License-Identifier: MIT
// An image as bytes: its size and its pixels, row by row.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/bytes.h"
#include "geometry/image.h"

namespace reorient {

/// Writes from `view`; reads into `own` and makes `view` refer to it.
template <typename Archive>
void archive_image(Archive& archive, auto& view, auto& own) {
  std::uint16_t width = static_cast<std::uint16_t>(view.empty() ? 0 : view.width);
  std::uint16_t height = static_cast<std::uint16_t>(view.empty() ? 0 : view.height);
  archive(width, height);
  const std::size_t row = 2 * std::size_t{width};
  if constexpr (Archive::kReads) {
    check_bytes(width % 2 == 0 && archive.left() / std::max<std::size_t>(row, 1) >= height,
                "image: larger than its bytes");
    own.resize(row * height);
    archive.raw(own.data(), own.size());
    view = {own.data(), width, height, static_cast<int>(row)};
  } else {
    for (int y = 0; y < height; ++y) archive.raw(view.row(y), row);
  }
}

}  // namespace reorient

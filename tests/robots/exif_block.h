// SPDX-License-Identifier: MIT
// EXIF blocks with an orientation, as cameras write them into JPEGs.
#pragma once

#include <cstdint>
#include <vector>

namespace reorient {

/// A TIFF header in little-endian byte order, and a directory with one entry.
inline std::vector<std::uint8_t> exif_block(int orientation) {
  const auto low = static_cast<std::uint8_t>(orientation & 0xff);
  const auto high = static_cast<std::uint8_t>(orientation >> 8);
  return {'I', 'I', 42, 0, 8, 0, 0, 0, 1, 0, 0x12, 1, 3, 0, 1, 0, 0, 0, low, high, 0, 0};
}

/// The same as a segment of a JPEG, to be inserted after its first two bytes.
inline std::vector<std::uint8_t> exif_segment(int orientation) {
  const std::vector<std::uint8_t> block = exif_block(orientation);
  const auto length = static_cast<std::uint8_t>(block.size() + 8);
  std::vector<std::uint8_t> segment{0xff, 0xe1, 0, length, 'E', 'x', 'i', 'f', 0, 0};
  segment.insert(segment.end(), block.begin(), block.end());
  return segment;
}

}  // namespace reorient

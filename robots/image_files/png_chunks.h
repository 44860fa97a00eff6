// SPDX-License-Identifier: MIT
// What the chunks of a PNG say (ISO/IEC 15948), without decoding it.
#pragma once

#include <cstdint>
#include <span>

namespace reorient {

struct PngChunks {
  bool has_end = false;  ///< the chunk IEND, complete
  int orientation = 1;   ///< of its chunk eXIf (exif_orientation.h)
};

bool looks_like_png(std::span<const std::uint8_t> bytes);

/// `bytes` look like a PNG. Checksums are not checked.
PngChunks read_png_chunks(std::span<const std::uint8_t> bytes);

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "robots/image_files/png_chunks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "robots/image_files/exif_orientation.h"

namespace reorient {
namespace {

constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

}  // namespace

bool looks_like_png(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= kSignature.size() && std::equal(kSignature.begin(), kSignature.end(), bytes.begin());
}

PngChunks read_png_chunks(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kHead = 8, kChecksum = 4;  // length and name; bytes
  PngChunks chunks;
  for (std::size_t at = kSignature.size(); bytes.size() - at >= kHead + kChecksum;) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8 | bytes[at + i];
    if (length > bytes.size() - at - kHead - kChecksum) break;
    const std::string_view name(reinterpret_cast<const char*>(bytes.data() + at + 4), 4);
    if (name == "eXIf") chunks.orientation = orientation_in_exif(bytes.subspan(at + kHead, length));
    if (name == "IEND") {
      chunks.has_end = true;
      break;
    }
    at += kHead + length + kChecksum;
  }
  return chunks;
}

}  // namespace reorient

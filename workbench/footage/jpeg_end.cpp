// SPDX-License-Identifier: MIT
#include "workbench/footage/jpeg_end.h"

namespace reorient {
namespace {

constexpr std::byte kMarker{0xff}, kStuffed{0x00}, kStartOfImage{0xd8}, kEndOfImage{0xd9};
constexpr std::byte kFirstRestart{0xd0};  // up to 0xd7, before the start of an image

/// Markers without length and data.
bool is_alone(std::byte code) { return code >= kFirstRestart && code <= kStartOfImage; }

}  // namespace

bool is_cut_off_jpeg(std::span<const std::byte> bytes) {
  if (bytes.size() < 3 || bytes[0] != kMarker || bytes[1] != kStartOfImage || bytes[2] != kMarker) return false;
  for (std::size_t at = 2; at + 1 < bytes.size();) {
    const std::byte code = bytes[at + 1];
    // Between two segments: the data of a scan, where a marker's first byte is followed by 0, and fill bytes.
    if (bytes[at] != kMarker || code == kStuffed || code == kMarker) {
      ++at;
      continue;
    }
    if (code == kEndOfImage) return false;
    at += 2;
    if (is_alone(code)) continue;
    if (at + 1 >= bytes.size()) break;
    at += 256 * std::to_integer<std::size_t>(bytes[at]) + std::to_integer<std::size_t>(bytes[at + 1]);
  }
  return true;
}

}  // namespace reorient

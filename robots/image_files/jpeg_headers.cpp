// SPDX-License-Identifier: MIT
#include "robots/image_files/jpeg_headers.h"

#include <algorithm>
#include <array>

#include "robots/image_files/exif_orientation.h"

namespace reorient {
namespace {

constexpr std::uint8_t kMarker = 0xff, kStuffed = 0x00, kStartOfImage = 0xd8, kEndOfImage = 0xd9, kStartOfScan = 0xda;
constexpr std::uint8_t kFirstRestart = 0xd0;  // up to 0xd7, before the start of an image
constexpr std::uint8_t kExif = 0xe1;          // APP1, which also contains other data

/// Markers without length and data.
bool is_alone(std::uint8_t code) { return code >= kFirstRestart && code <= kStartOfImage; }

bool is_start_of_frame(std::uint8_t code) {
  constexpr std::array<std::uint8_t, 3> kOthers{0xc4, 0xc8, 0xcc};  // Huffman tables, reserved, arithmetic conditioning
  return code >= 0xc0 && code <= 0xcf && std::find(kOthers.begin(), kOthers.end(), code) == kOthers.end();
}

/// Calls `visit` with the code and the data of each segment up to the end of the image. False: the end is missing.
template <typename Visit>
bool visit_segments(std::span<const std::uint8_t> bytes, Visit&& visit) {
  for (std::size_t at = 2; at + 1 < bytes.size();) {
    const std::uint8_t code = bytes[at + 1];
    // Between two segments: the data of a scan, where a marker's first byte is followed by 0, and fill bytes.
    if (bytes[at] != kMarker || code == kStuffed || code == kMarker) {
      ++at;
      continue;
    }
    if (code == kEndOfImage) return true;
    at += 2;
    if (is_alone(code)) continue;
    if (at + 1 >= bytes.size()) break;
    const std::size_t length = std::size_t{256} * bytes[at] + bytes[at + 1];  // with these two bytes
    const std::size_t begin = std::min(at + 2, bytes.size()), end = std::min(at + length, bytes.size());
    visit(code, bytes.subspan(begin, std::max(begin, end) - begin));
    at += length;
  }
  return false;
}

void read_start_of_frame(std::uint8_t code, std::span<const std::uint8_t> data, JpegHeaders& headers) {
  constexpr std::size_t kLeast = 6;
  if (data.size() < kLeast) return;
  headers.process = code & 0x0f;
  headers.bits = data[0];
  headers.height = 256 * data[1] + data[2];
  headers.width = 256 * data[3] + data[4];
  headers.colors = data[5];
}

}  // namespace

bool looks_like_jpeg(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 3 && bytes[0] == kMarker && bytes[1] == kStartOfImage && bytes[2] == kMarker;
}

JpegHeaders read_jpeg_headers(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint8_t, 6> kExifName{'E', 'x', 'i', 'f', 0, 0};
  JpegHeaders headers;
  bool has_exif = false;
  headers.has_end = visit_segments(bytes, [&](std::uint8_t code, std::span<const std::uint8_t> data) {
    if (code == kStartOfScan) ++headers.scans;
    if (is_start_of_frame(code) && headers.process < 0) read_start_of_frame(code, data, headers);
    if (code != kExif || has_exif || data.size() < kExifName.size()) return;
    has_exif = std::equal(kExifName.begin(), kExifName.end(), data.begin());
    if (has_exif) headers.orientation = orientation_in_exif(data.subspan(kExifName.size()));
  });
  return headers;
}

std::string undecodable(const JpegHeaders& jpeg) {
  constexpr int kMostScans = 50;
  constexpr std::array<int, 5> kProcesses{0, 1, 2, 9, 10};  // the last two with arithmetic coding
  if (jpeg.process < 0) return "";                          // damaged; a decoder says where
  if (std::find(kProcesses.begin(), kProcesses.end(), jpeg.process) == kProcesses.end()) {
    return "expected a baseline or progressive JPEG, found a lossless or hierarchical one (process " +
           std::to_string(jpeg.process) + "); export it as an ordinary JPEG";
  }
  if (jpeg.bits != 8)
    return "expected a JPEG with 8 bits per color, found " + std::to_string(jpeg.bits) + "; export it with 8 bits";
  if (jpeg.colors != 1 && jpeg.colors != 3 && jpeg.colors != 4)
    return "expected a JPEG with 1, 3 or 4 colors, found " + std::to_string(jpeg.colors) + "; export it in sRGB";
  if (jpeg.scans > kMostScans) {
    return "expected a JPEG with at most " + std::to_string(kMostScans) + " scans, found " +
           std::to_string(jpeg.scans) + "; export it again";
  }
  return "";
}

}  // namespace reorient

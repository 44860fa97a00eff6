// SPDX-License-Identifier: MIT
// What the markers of a JPEG say (ITU-T T.81, annex B), without decoding it. Decoders fill a missing part with gray,
// and do not name what they cannot decode.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace reorient {

struct JpegHeaders {
  int process = -1;  ///< low half of the start-of-frame marker: 0 baseline, 1 extended, 2 progressive, 3 lossless, ...;
                     ///< -1: missing
  int bits = 0;      ///< per color
  int width = 0;     ///< pixels, as stored
  int height = 0;    ///< pixels, as stored
  int colors = 0;    ///< 1 gray, 3 RGB, 4 CMYK
  int scans = 0;
  bool has_end = false;  ///< the end-of-image marker; what follows it is not part of the image
  int orientation = 1;   ///< of its first EXIF block (exif_orientation.h)
};

/// The bytes FF D8 FF.
bool looks_like_jpeg(std::span<const std::uint8_t> bytes);

/// `bytes` look like a JPEG.
JpegHeaders read_jpeg_headers(std::span<const std::uint8_t> bytes);

/// Why no decoder of this program can decode it, as "expected ..., found ...; remedy", or empty. Does not require the
/// end. A progressive image is decoded once for each scan, and a scan may have few bytes, so their number is limited.
std::string undecodable(const JpegHeaders& jpeg);

}  // namespace reorient

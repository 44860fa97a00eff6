// SPDX-License-Identifier: MIT
#include "robots/footage/raw_image.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "robots/footage/messages/bad_message.h"
#include "robots/image_formats.h"

namespace reorient {
namespace {

struct Encoding {
  std::string_view name;
  PixelFormat format;
};

// Names from sensor_msgs/image_encodings.hpp and foxglove.RawImage.
constexpr std::array kEncodings = std::to_array<Encoding>({
    {"rgb8", PixelFormat::rgb},
    {"bgr8", PixelFormat::bgr},
    {"rgba8", PixelFormat::rgba},
    {"bgra8", PixelFormat::bgra},
    {"mono8", PixelFormat::gray},
    {"yuv422", PixelFormat::uyvy},
    {"uyvy", PixelFormat::uyvy},
    {"yuv422_yuy2", PixelFormat::yuyv},
    {"yuyv", PixelFormat::yuyv},
    {"nv12", PixelFormat::nv12},
});

PixelFormat format_of(const std::string& encoding) {
  const auto* const it =
      std::find_if(kEncodings.begin(), kEncodings.end(), [&](const Encoding& each) { return each.name == encoding; });
  if (it != kEncodings.end()) return it->format;
  std::string known;
  for (const Encoding& each : kEncodings) {
    if (!known.empty()) known += ", ";
    known += each.name;
  }
  throw BadFootage("image encoding: expected one of " + known + ", found " + messages::in_quotes(encoding));
}

}  // namespace

Image image_of(const messages::RawImage& raw) {
  const PixelFormat format = format_of(raw.encoding);
  constexpr std::uint32_t kLargest = 16384;
  if (raw.width < 2 || raw.height < 1 || raw.width > kLargest || raw.height > kLargest) {
    throw BadFootage("image size: expected 2x1 to 16384x16384 pixels, found " + std::to_string(raw.width) + "x" +
                     std::to_string(raw.height));
  }
  const int width = static_cast<int>(raw.width), height = static_cast<int>(raw.height);
  const std::size_t row = row_bytes(format, width);
  if (raw.step < row) {
    throw BadFootage("image step: expected at least " + std::to_string(row) + " bytes for " +
                     std::to_string(raw.width) + " pixels of " + raw.encoding + ", found " + std::to_string(raw.step));
  }
  const std::size_t needed = image_bytes(format, width, height, raw.step);
  if (raw.data.size() < needed) {
    throw BadFootage("image data: expected at least " + std::to_string(needed) + " bytes, found " +
                     std::to_string(raw.data.size()));
  }
  Image image(width / 2 * 2, height);
  convert_image({reinterpret_cast<const std::uint8_t*>(raw.data.data()), raw.data.size()}, format, raw.step, image);
  return image;
}

}  // namespace reorient

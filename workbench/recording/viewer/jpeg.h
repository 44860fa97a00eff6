// SPDX-License-Identifier: MIT
// Camera images as JPEG, for people to look at.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/image.h"

namespace reorient {

class JpegEncoder {
 public:
  /// `quality`: 1 to 100.
  explicit JpegEncoder(int quality);

  /// Valid until the next call; empty where the image is. A camera's two pixels with one color are what JPEG calls
  /// 4:2:2, so that nothing is converted. Throws std::runtime_error with one line.
  std::span<const std::byte> encode(const ImageView& image);

 private:
  int quality_;
  std::unique_ptr<void, int (*)(void*)> encoder_;
  std::vector<std::uint8_t> luma_, cb_, cr_, jpeg_;
};

}  // namespace reorient

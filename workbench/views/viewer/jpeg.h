// SPDX-License-Identifier: MIT
// Camera images as JPEG, for viewers.
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

  /// Valid until the next call; empty if the image is empty. Two pixels of the camera share a color, which is 4:2:2 in
  /// JPEG, so no conversion is needed. Throws std::runtime_error with one line.
  std::span<const std::byte> encode(const ImageView& image);

 private:
  int quality_;
  std::unique_ptr<void, int (*)(void*)> encoder_;
  std::vector<std::uint8_t> luma_, cb_, cr_, jpeg_;
};

}  // namespace reorient

// SPDX-License-Identifier: MIT
// The interface of the decoder of images and videos, passed in because its library is optional (decoder_library.h).
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "geometry/image.h"

namespace reorient {

/// A video that is read frame by frame.
class FrameReader {
 public:
  virtual ~FrameReader() = default;
  /// False: no frame is left. Throws BadFootage.
  virtual bool next(Image& image) = 0;
  /// Frames per second from the file; 0: the file does not contain it.
  virtual double frames_per_second() const = 0;
};

struct FootageDecoder {
  /// `where`: for messages. Throws BadFootage if the bytes are not an image.
  std::function<Image(std::span<const std::byte> bytes, const std::string& where)> image;
  /// Throws BadFootage if the file is not a readable video.
  std::function<std::unique_ptr<FrameReader>(const std::filesystem::path& file)> video;
};

}  // namespace reorient

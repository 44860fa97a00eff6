// SPDX-License-Identifier: MIT
// Who decodes images and videos. The library that can (decoder_library.h) is optional, so it is handed in.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "geometry/image.h"

namespace reorient {

/// A video that is read frame after frame.
class FrameReader {
 public:
  virtual ~FrameReader() = default;
  /// False: there is no frame any more. Throws BadFootage.
  virtual bool next(Image& image) = 0;
  /// As the file says; 0: it does not.
  virtual double frames_per_second() const = 0;
};

struct FootageDecoder {
  /// `where`: for messages. Throws BadFootage where the bytes are no image.
  std::function<Image(std::span<const std::byte> bytes, const std::string& where)> image;
  /// Throws BadFootage where the file is no video that can be read.
  std::function<std::unique_ptr<FrameReader>(const std::filesystem::path& file)> video;
};

}  // namespace reorient

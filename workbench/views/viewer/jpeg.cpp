// SPDX-License-Identifier: MIT
#include "workbench/views/viewer/jpeg.h"

#include <stdexcept>
#include <string>

#include <turbojpeg.h>

namespace reorient {

JpegEncoder::JpegEncoder(int quality) : quality_(quality), encoder_(tjInitCompress(), tjDestroy) {
  if (!encoder_) throw std::runtime_error(std::string("cannot encode a JPEG: ") + tjGetErrorStr2(nullptr));
}

std::span<const std::byte> JpegEncoder::encode(const ImageView& image) {
  if (image.empty()) return {};
  const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  luma_.resize(width * height);
  cb_.resize(width / 2 * height);
  cr_.resize(width / 2 * height);
  for (std::size_t y = 0; y < height; ++y) {
    const std::uint8_t* const row = image.row(static_cast<int>(y));
    std::uint8_t* const luma = luma_.data() + y * width;
    std::uint8_t* const cb = cb_.data() + y * (width / 2);
    std::uint8_t* const cr = cr_.data() + y * (width / 2);
    for (std::size_t pair = 0; pair < width / 2; ++pair) {
      luma[2 * pair] = row[4 * pair];
      cb[pair] = row[4 * pair + 1];
      luma[2 * pair + 1] = row[4 * pair + 2];
      cr[pair] = row[4 * pair + 3];
    }
  }
  jpeg_.resize(tjBufSize(image.width, image.height, TJSAMP_422));
  const unsigned char* planes[] = {luma_.data(), cb_.data(), cr_.data()};
  unsigned char* place = jpeg_.data();
  unsigned long size = jpeg_.size();
  if (tjCompressFromYUVPlanes(encoder_.get(), planes, image.width, nullptr, image.height, TJSAMP_422, &place, &size,
                              quality_, TJFLAG_NOREALLOC) != 0)
    throw std::runtime_error(std::string("cannot encode a JPEG: ") + tjGetErrorStr2(encoder_.get()));
  return std::as_bytes(std::span(jpeg_.data(), size));
}

}  // namespace reorient

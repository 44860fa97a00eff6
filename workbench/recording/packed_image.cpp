// SPDX-License-Identifier: MIT
#include "workbench/recording/packed_image.h"

#include <cstdint>

#include "geometry/bytes.h"

namespace reorient {
namespace {

// Offset of the first value of a component in a pair of pixels, and step to the next one: Y0 Cb Y1 Cr.
struct Plane {
  std::size_t first, step;
};
constexpr Plane kPlanes[] = {{0, 2}, {1, 4}, {3, 4}};

}  // namespace

void pack_image(const ImageView& image, std::vector<std::byte>& bytes) {
  ByteWriter{bytes}(static_cast<std::uint16_t>(image.width), static_cast<std::uint16_t>(image.height));
  const std::size_t row = 2 * static_cast<std::size_t>(image.width);
  std::size_t at = bytes.size();
  bytes.resize(at + row * static_cast<std::size_t>(image.height));
  for (const Plane& plane : kPlanes) {
    for (int y = 0; y < image.height; ++y) {
      const std::uint8_t* const pixels = image.row(y);
      std::uint8_t left = 0;
      for (std::size_t i = plane.first; i < row; i += plane.step) {
        bytes[at++] = static_cast<std::byte>(pixels[i] - left);
        left = pixels[i];
      }
    }
  }
}

void unpack_image(std::span<const std::byte> bytes, Image& image) {
  ByteReader in(bytes);
  std::uint16_t width = 0, height = 0;
  in(width, height);
  const std::size_t pixels = std::size_t{width} * height;
  check_bytes(width % 2 == 0 && in.left() == 2 * pixels, "the number of bytes of an image does not fit its size");
  if (image.width() != width || image.height() != height) image = Image(width, height);
  // All planes together, so that each pair of pixels is written once.
  const auto* luma = reinterpret_cast<const std::uint8_t*>(bytes.data()) + (bytes.size() - in.left());
  const std::uint8_t* cb = luma + pixels;
  const std::uint8_t* cr = cb + pixels / 2;
  for (int y = 0; y < height; ++y) {
    std::uint8_t* pair = image.row(y);
    std::uint8_t left_luma = 0, left_cb = 0, left_cr = 0;
    for (int x = 0; x < width; x += 2, pair += 4) {
      const auto first = static_cast<std::uint8_t>(left_luma + *luma++);
      left_luma = static_cast<std::uint8_t>(first + *luma++);
      left_cb = static_cast<std::uint8_t>(left_cb + *cb++);
      left_cr = static_cast<std::uint8_t>(left_cr + *cr++);
      pair[0] = first;
      pair[1] = left_cb;
      pair[2] = left_luma;
      pair[3] = left_cr;
    }
  }
}

}  // namespace reorient

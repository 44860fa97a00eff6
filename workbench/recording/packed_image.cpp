#include "workbench/recording/packed_image.h"

#include <cstdint>

#include "geometry/bytes.h"

namespace reorient {
namespace {

// Where a value of the first pixel of a pair lies, and how far it is to the next one: Y0 Cb Y1 Cr.
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

Image unpack_image(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  std::uint16_t width = 0, height = 0;
  in(width, height);
  const std::size_t row = 2 * std::size_t{width};
  check_bytes(width % 2 == 0 && in.left() == row * height, "an image has not as many bytes as pixels");
  Image image(width, height);
  std::size_t at = bytes.size() - in.left();
  for (const Plane& plane : kPlanes) {
    for (int y = 0; y < height; ++y) {
      std::uint8_t* const pixels = image.row(y);
      std::uint8_t left = 0;
      for (std::size_t i = plane.first; i < row; i += plane.step) {
        left = static_cast<std::uint8_t>(left + static_cast<std::uint8_t>(bytes[at++]));
        pixels[i] = left;
      }
    }
  }
  return image;
}

}  // namespace reorient

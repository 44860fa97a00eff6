// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/canvas/png_file.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <png.h>

#include "workbench/files/atomic_file.h"

namespace reorient::pictures {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw std::runtime_error("cannot write picture " + file.string() + ": " + reason +
                           "; name a folder that exists and is writable");
}

std::vector<char> encode(const std::filesystem::path& file, const Picture& picture) {
  const auto expected = 3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  if (picture.width <= 0 || picture.height <= 0 || picture.bytes.size() != expected)
    throw std::invalid_argument("cannot write picture " + file.string() + ": it has no pixels");
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(picture.width);
  header.height = static_cast<png_uint_32>(picture.height);
  header.format = PNG_FORMAT_RGB;
  std::vector<char> encoded(PNG_IMAGE_PNG_SIZE_MAX(header));
  png_alloc_size_t size = encoded.size();
  if (png_image_write_to_memory(&header, encoded.data(), &size, 0, picture.bytes.data(), 0, nullptr) == 0)
    refuse(file, header.message);
  encoded.resize(size);
  return encoded;
}

}  // namespace

void write_png(const std::filesystem::path& file, const Picture& picture) {
  const std::vector<char> encoded = encode(file, picture);
  write_whole_file(file, {encoded.data(), encoded.size()});
}

}  // namespace reorient::pictures

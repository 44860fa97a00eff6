// SPDX-License-Identifier: MIT
#include "robots/image_files/exif_orientation.h"

#include <algorithm>
#include <array>
#include <utility>

namespace reorient {
namespace {

/// Numbers of a TIFF file in its byte order. 0 beyond its end.
class TiffNumbers {
 public:
  explicit TiffNumbers(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool is_tiff() const {
    constexpr std::uint32_t kMagic = 42;
    return bytes_.size() >= 8 && bytes_[0] == bytes_[1] && (is_little_endian() || bytes_[0] == 'M') &&
           number(2, 2) == kMagic;
  }
  std::uint32_t number(std::size_t at, std::size_t size) const {
    std::uint32_t value = 0;
    if (at > bytes_.size() || size > bytes_.size() - at) return 0;
    for (std::size_t i = 0; i < size; ++i) value = value << 8 | bytes_[at + (is_little_endian() ? size - 1 - i : i)];
    return value;
  }

 private:
  bool is_little_endian() const { return bytes_[0] == 'I'; }

  std::span<const std::uint8_t> bytes_;
};

}  // namespace

int orientation_in_exif(std::span<const std::uint8_t> exif) {
  constexpr std::size_t kDirectory = 4, kCount = 2, kEntry = 12, kType = 2, kValue = 8;  // offsets and sizes in bytes
  constexpr std::uint32_t kOrientation = 0x0112, kShort = 3, kLong = 4, kMost = 8;
  const TiffNumbers in(exif);
  if (!in.is_tiff()) return 1;
  const std::size_t directory = in.number(kDirectory, 4);
  const std::size_t entries = std::min<std::size_t>(in.number(directory, 2), exif.size() / kEntry);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t entry = directory + kCount + kEntry * i;
    if (in.number(entry, 2) != kOrientation) continue;
    const std::uint32_t type = in.number(entry + kType, 2);
    const std::uint32_t value = type == kShort  ? in.number(entry + kValue, 2)
                                : type == kLong ? in.number(entry + kValue, 4)
                                                : 1;
    return value >= 1 && value <= kMost ? static_cast<int>(value) : 1;
  }
  return 1;
}

ShownImage::ShownImage(int width, int height, int orientation) : stored_width_(width), stored_height_(height) {
  constexpr std::array<bool, 8> kColumns{false, true, true, false, false, false, true, true};
  constexpr std::array<bool, 8> kRows{false, false, true, true, false, true, true, false};
  const auto index = static_cast<std::size_t>(orientation - 1);
  is_transposed_ = orientation > 4;
  columns_are_mirrored_ = kColumns.at(index);
  rows_are_mirrored_ = kRows.at(index);
}

std::size_t ShownImage::stored(int x, int y) const {
  if (is_transposed_) std::swap(x, y);
  if (columns_are_mirrored_) x = stored_width_ - 1 - x;
  if (rows_are_mirrored_) y = stored_height_ - 1 - y;
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(stored_width_) + static_cast<std::size_t>(x);
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
// The orientation in which an image is shown (EXIF 2.3, tag 0x0112). Cameras store an image as their sensor reads it,
// and note how they were held.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace reorient {

/// From 1 (as stored) to 8. `exif`: a TIFF header and what follows it. 1 if it contains no valid orientation.
int orientation_in_exif(std::span<const std::uint8_t> exif);

/// Maps pixels of the image that is shown to those that are stored.
class ShownImage {
 public:
  /// `width`, `height`: as stored. `orientation`: 1 to 8.
  ShownImage(int width, int height, int orientation);

  int width() const { return is_transposed_ ? stored_height_ : stored_width_; }
  int height() const { return is_transposed_ ? stored_width_ : stored_height_; }

  /// Index of a stored pixel, counted in rows from the top. `x`, `y`: position of the pixel that is shown.
  std::size_t stored(int x, int y) const;

 private:
  int stored_width_;
  int stored_height_;
  bool is_transposed_;
  bool columns_are_mirrored_;  ///< of the stored image
  bool rows_are_mirrored_;
};

}  // namespace reorient

// SPDX-License-Identifier: MIT
// A handful of colors that are typical of a room, found by k-means, and which of them a pixel is nearest to.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/image.h"

namespace reorient {

class ColorClasses {
 public:
  /// Lloyd's algorithm from k-means++ (Arthur and Vassilvitskii 2007). At most 64 classes. Where there are fewer
  /// different colors than classes, some classes stay empty. Chroma counts `chroma` times as much as luma.
  static ColorClasses of(std::span<const Ycbcr> colors, int classes, double chroma, std::uint64_t seed);

  int count() const { return count_; }
  /// The class of a color, to within 8 levels.
  int operator()(const Ycbcr& color) const { return table_[cell_of(color)]; }

 private:
  static constexpr int kShift = 3;  // levels of a cell: 8
  static constexpr int kCells = 256 >> kShift;
  static std::size_t cell_of(const Ycbcr& color) {
    return static_cast<std::size_t>(((color.y >> kShift) * kCells + (color.cb >> kShift)) * kCells +
                                    (color.cr >> kShift));
  }

  int count_ = 0;
  std::vector<std::uint8_t> table_;
};

/// Over which time the mean color of the room runs, so that its light can be taken off: none where `memory` is 0, as
/// in methods that know no light.
class RunningLight {
 public:
  /// A pixel of the room. All of a frame, then next_frame().
  void add(const Ycbcr& color);
  void next_frame(double time, double memory);
  /// A color as it would be where the mean is a medium gray.
  Ycbcr without_light(const Ycbcr& color) const;
  bool is_known() const { return known_; }
  double luma() const { return luma_; }
  double cb() const { return cb_; }
  double cr() const { return cr_; }

 private:
  double luma_ = 115.0, cb_ = 128.0, cr_ = 128.0;
  double sum_luma_ = 0.0, sum_cb_ = 0.0, sum_cr_ = 0.0;
  int pixels_ = 0;  // of this frame
  double last_time_ = 0.0;
  bool known_ = false;
};

}  // namespace reorient

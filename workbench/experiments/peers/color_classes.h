// SPDX-License-Identifier: MIT
// Typical colors of a room, found by k-means, and the nearest one of a pixel.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/image.h"

namespace reorient {

class ColorClasses {
 public:
  /// Lloyd's algorithm from k-means++ (Arthur and Vassilvitskii 2007). At most 64 classes. With fewer different
  /// colors than classes, some classes stay empty. Chroma has `chroma` times the weight of luma.
  static ColorClasses of(std::span<const Ycbcr> colors, int classes, double chroma, std::uint64_t seed);

  int count() const { return count_; }
  /// The class of a color, with a resolution of 8 levels.
  int operator()(const Ycbcr& color) const { return table_[cell_of(color)]; }

 private:
  static constexpr int kShift = 3;  // 2^3 = 8 levels in a cell
  static constexpr int kCells = 256 >> kShift;
  static std::size_t cell_of(const Ycbcr& color) {
    return static_cast<std::size_t>(((color.y >> kShift) * kCells + (color.cb >> kShift)) * kCells +
                                    (color.cr >> kShift));
  }

  int count_ = 0;
  std::vector<std::uint8_t> table_;
};

/// A running mean of the room's color over `memory` seconds, to remove the light. With 0 colors are unchanged, as in
/// methods without a model of light.
class RunningLight {
 public:
  /// Adds a pixel of the room. Call for all pixels of a frame, then next_frame().
  void add(const Ycbcr& color);
  void next_frame(double time, double memory);
  /// The color if the mean were a medium gray.
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

// SPDX-License-Identifier: MIT
// A coarse grid over the image that separates carpet from everything else.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/image.h"
#include "perception/field/carpet/carpet_color.h"

namespace reorient {

class CarpetMap {
 public:
  static constexpr int kColumns = 80;
  static constexpr int kMostRows = 240;

  CarpetMap() : cells_(static_cast<std::size_t>(kColumns) * kMostRows) {}

  /// Uses rows of the image from `first_row` down. The cells above are not computed.
  void fill(const ImageView& image, const CarpetColor& color, int first_row);

  int rows() const { return rows_; }
  int first_cell() const { return first_; }  ///< the highest row of computed cells
  Surface at(int column, int row) const {
    return cells_[static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column)];
  }

  int column_pixel(int column) const { return (2 * column + 1) * width_ / (2 * kColumns); }
  int row_pixel(int row) const { return row * step_; }
  int step() const { return step_; }  ///< pixels from row to row
  double column_width() const { return static_cast<double>(width_) / kColumns; }

 private:
  static constexpr int kMostRowsAtOnce = 20;
  static constexpr std::size_t kMostAtOnce = std::size_t{kMostRowsAtOnce} * kColumns;
  /// `last` column and row are excluded.
  struct Cells {
    int left, top, right, bottom;
  };
  void fill(const ImageView& image, const CarpetPart& part, const Cells& cells);

  std::vector<Surface> cells_;
  std::array<int, kColumns> pairs_{};  ///< bytes from the start of a row to the pair of pixels of a column
  std::array<int, kMostAtOnce> y_{}, cb_{}, cr_{}, found_{};
  int width_ = 0;
  int rows_ = 0;
  int first_ = 0;
  int step_ = 1;
};

}  // namespace reorient

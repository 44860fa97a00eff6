// SPDX-License-Identifier: MIT
#include "perception/field/carpet/carpet_map.h"

#include <algorithm>
#include <array>

#include "geometry/wide.h"

namespace reorient {

void CarpetMap::fill(const ImageView& image, const CarpetColor& color, int first_row) {
  width_ = image.width;
  step_ = (image.height + kMostRows - 1) / kMostRows;
  rows_ = (image.height + step_ - 1) / step_;
  first_ = std::clamp(first_row / step_, 0, rows_);
  std::array<int, kColumns> part_columns{};
  for (int i = 0; i < kColumns; ++i) {
    part_columns[static_cast<std::size_t>(i)] = color.column_of(column_pixel(i));
    pairs_[static_cast<std::size_t>(i)] = 4 * (column_pixel(i) / 2);
  }
  for (int top = first_; top < rows_;) {
    int bottom = top + 1;
    const int part_row = color.row_of(top * step_);
    while (bottom < rows_ && bottom - top < kMostRowsAtOnce && color.row_of(bottom * step_) == part_row) ++bottom;
    for (int left = 0; left < kColumns;) {
      int right = left + 1;
      const int part_column = part_columns[static_cast<std::size_t>(left)];
      while (right < kColumns && part_columns[static_cast<std::size_t>(right)] == part_column) ++right;
      fill(image, color.part(part_column, part_row), {left, top, right, bottom});
      left = right;
    }
    top = bottom;
  }
}

/// Processes the cells of one part. Each step handles all cells, so that the compiler can vectorize it.
REORIENT_WIDE void CarpetMap::fill(const ImageView& image, const CarpetPart& part, const Cells& cells) {
  std::size_t count = 0;
  const auto each_cell = [&](auto&& with) {
    for (int j = cells.top; j < cells.bottom; ++j) {
      for (int i = cells.left; i < cells.right; ++i) with(i, j);
    }
  };
  each_cell([&](int i, int j) {
    const std::uint8_t* pair = image.row(j * step_) + pairs_[static_cast<std::size_t>(i)];
    y_[count] = (pair[0] + pair[2]) / 2;
    cb_[count] = pair[1];
    cr_[count++] = pair[3];
  });
  const CarpetPart own = part;  // a local copy, which cannot alias other memory
  for (std::size_t k = 0; k < count; ++k) found_[k] = static_cast<int>(own.surface(y_[k], cb_[k], cr_[k]));
  count = 0;
  each_cell([&](int i, int j) {
    cells_[static_cast<std::size_t>(j) * kColumns + static_cast<std::size_t>(i)] =
        static_cast<Surface>(found_[count++]);
  });
}

}  // namespace reorient

#include "perception/field/carpet/carpet_map.h"

#include <algorithm>
#include <array>
#include <span>

namespace reorient {

void CarpetMap::fill(const ImageView& image, const CarpetColor& color, int first_row) {
  width_ = image.width;
  step_ = (image.height + kMostRows - 1) / kMostRows;
  rows_ = (image.height + step_ - 1) / step_;
  first_ = std::clamp(first_row / step_, 0, rows_);
  std::array<std::size_t, kColumns> parts{};
  for (int i = 0; i < kColumns; ++i)
    parts[static_cast<std::size_t>(i)] = static_cast<std::size_t>(color.column_of(column_pixel(i)));
  Surface* cell = cells_.data() + static_cast<std::ptrdiff_t>(first_) * kColumns;
  for (int j = first_; j < rows_; ++j) {
    const std::uint8_t* row = image.row(j * step_);
    const std::span<const CarpetPart> carpet = color.row_at(j * step_);
    for (int i = 0; i < kColumns; ++i, ++cell) {
      const std::uint8_t* pair = row + 4 * (column_pixel(i) / 2);
      *cell = carpet[parts[static_cast<std::size_t>(i)]].surface((pair[0] + pair[2]) / 2, pair[1], pair[3]);
    }
  }
}

}  // namespace reorient

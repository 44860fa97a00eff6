// SPDX-License-Identifier: MIT
#include "perception/room/color/color_counting.h"

#include <algorithm>

#include "perception/room/color/counting_kernels.h"

namespace reorient {
namespace {

/// The part of the block inside of the image.
PixelBlock within(const ImageView& image, const PixelBlock& block) {
  if (image.empty()) return {};
  return {std::max(block.left, 0), std::max(block.top, 0), std::min(block.right, image.width & ~1),
          std::min(block.bottom, image.height)};
}

void count_one_by_one(const PixelRows& rows, int begin, int end, const ColorThresholds& thresholds,
                      ColorCounts& counts) {
  for (int i = 0; i < rows.count; ++i) {
    const std::uint8_t* row = rows.first + i * rows.step;
    for (int x = begin; x < end; ++x) {
      const std::uint8_t* pair = row + 4 * (x / 2);
      ++counts[static_cast<std::size_t>(color_bin({pair[2 * (x % 2)], pair[1], pair[3]}, thresholds))];
    }
  }
}

CountingKernel* counting_of(Instructions instructions) {
  if (instructions == Instructions::neon) return neon_kernel();
  return instructions == Instructions::avx2 ? avx2_kernel() : sse4_kernel();
}

}  // namespace

void count_colors(const ImageView& image, const PixelBlock& block, int row_step, const ColorThresholds& thresholds,
                  ColorCounts& counts, Instructions instructions) {
  const PixelBlock part = within(image, block);
  if (part.left >= part.right || part.top >= part.bottom) return;
  const int step = std::max(row_step, 1);
  const PixelRows rows{image.row(part.top), static_cast<std::ptrdiff_t>(step) * image.stride,
                       (part.bottom - part.top + step - 1) / step, image.width & ~1};
  if (instructions == Instructions::avx2 && rows.width < 16) instructions = Instructions::sse4;
  if (instructions != Instructions::avx2 && rows.width < 8) instructions = Instructions::portable;
  if (instructions == Instructions::portable) return count_one_by_one(rows, part.left, part.right, thresholds, counts);

  // Two pixels share their chroma. A single pixel of a pair is counted separately.
  const int begin = part.left + part.left % 2;
  const int end = part.right - part.right % 2;
  count_one_by_one(rows, part.left, begin, thresholds, counts);
  if (begin < end) counting_of(instructions)(rows, begin, end, thresholds, counts.data());
  count_one_by_one(rows, end, part.right, thresholds, counts);
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Counts the colors of a block of pixels. This is the only loop of room awareness over the image. It has several
// versions with the same results (perception/room/instructions.h).
#pragma once

#include "geometry/image.h"
#include "perception/room/color/color_histogram.h"
#include "perception/room/instructions.h"

namespace reorient {

/// Part of an image: columns left...right - 1, and every row_step-th of the rows top...bottom - 1, starting at the top.
struct PixelBlock {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

/// Adds the pixels of a block to `counts`. Pixels outside of the image do not count. The processor must support
/// `instructions`. The wide versions process 16 and 32 pixels at a time, the portable one processes single pixels by
/// the definition (color_bin). For images narrower than the registers, a narrower version is used.
void count_colors(const ImageView& image, const PixelBlock& block, int row_step, const ColorThresholds& thresholds,
                  ColorCounts& counts, Instructions instructions = widest_instructions());

}  // namespace reorient

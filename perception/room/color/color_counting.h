// SPDX-License-Identifier: MIT
// Counting the colours of a block of pixels: the one loop of room awareness that goes through the image. It exists in
// three versions with the same results (perception/room/instructions.h).
#pragma once

#include "geometry/image.h"
#include "perception/room/color/color_histogram.h"
#include "perception/room/instructions.h"

namespace reorient {

/// Part of an image: columns left...right - 1 and of the rows top...bottom - 1 every row_step-th, from the top one on.
struct PixelBlock {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

/// Adds the pixels of a block to `counts`. What lies outside of the image does not count. `instructions`: must be
/// offered; the wide versions take 16 and 32 pixels at a time, the portable one, by the definition (color_bin), one.
/// Images that are narrower than the registers are counted by a narrower version.
void count_colors(const ImageView& image, const PixelBlock& block, int row_step, const ColorThresholds& thresholds,
                  ColorCounts& counts, Instructions instructions = widest_instructions());

}  // namespace reorient

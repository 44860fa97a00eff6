// Counting the colours of a block of pixels: the one loop of room awareness that goes through the image. It exists in
// three versions with the same results; the fastest that the processor offers is taken when the program runs.
#pragma once

#include "geometry/image.h"
#include "perception/room/color/color_histogram.h"

namespace reorient {

/// Part of an image: columns left...right - 1 and of the rows top...bottom - 1 every row_step-th, from the top one on.
struct PixelBlock {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

/// What a version asks of the processor, and how many pixels it takes at a time.
enum class Instructions {
  portable,  ///< nothing; one, by the definition (color_bin)
  sse4,      ///< SSE4.2; 16
  avx2       ///< AVX2; 32
};

/// Whether this program on this processor can count so.
bool offered(Instructions instructions);
/// The widest that is offered.
Instructions widest_instructions();

/// Adds the pixels of a block to `counts`. What lies outside of the image does not count. `instructions`: must be
/// offered; images that are narrower than the registers are counted by a narrower version.
void count_colors(const ImageView& image, const PixelBlock& block, int row_step, const ColorThresholds& thresholds,
                  ColorCounts& counts, Instructions instructions = widest_instructions());

}  // namespace reorient

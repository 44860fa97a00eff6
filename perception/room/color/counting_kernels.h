// SPDX-License-Identifier: MIT
// The versions of color_counting.h that need more than every processor has. Each is a source that is compiled for its
// instructions. To keep code of a newer processor out of everything else, such a source calls no inline function that
// another source may call, too: the linker keeps just one copy of it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "perception/room/color/color_histogram.h"

namespace reorient {

/// Some rows of an image, as bytes Y0 Cb Y1 Cr.
struct PixelRows {
  const std::uint8_t* first = nullptr;
  std::ptrdiff_t step = 0;  ///< bytes from one to the next
  int count = 0;
  int width = 0;  ///< pixels
};

/// Adds pixels begin...end - 1 of each row to `counts`, one for each bin. Both are even, begin is less than end, and
/// the rows are at least half as wide as the registers.
using CountingKernel = void(const PixelRows& rows, int begin, int end, const ColorThresholds& thresholds,
                            std::uint32_t* counts);

/// Null where the program is compiled for another kind of processor.
CountingKernel* sse4_kernel();
CountingKernel* avx2_kernel();
CountingKernel* neon_kernel();

}  // namespace reorient

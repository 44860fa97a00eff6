// SPDX-License-Identifier: MIT
// The versions of color_counting.h that need optional instructions of processors. Each is a source file that is
// compiled for its instructions. Such a file must not call inline functions that other files may also call. The linker
// keeps only one copy of each, and instructions of newer processors would reach the rest of the program.
#pragma once

#include <cstddef>
#include <cstdint>

#include "perception/room/color/color_histogram.h"

namespace reorient {

/// Some rows of an image, as bytes Y0 Cb Y1 Cr.
struct PixelRows {
  const std::uint8_t* first = nullptr;
  std::ptrdiff_t step = 0;  ///< bytes from one row to the next
  int count = 0;
  int width = 0;  ///< pixels
};

/// Adds pixels begin...end - 1 of each row to `counts`, one for each bin. Both numbers are even, begin is less than
/// end, and the rows are at least half as wide as the registers.
using CountingKernel = void(const PixelRows& rows, int begin, int end, const ColorThresholds& thresholds,
                            std::uint32_t* counts);

/// Null if the program is compiled for another type of processor.
CountingKernel* sse4_kernel();
CountingKernel* avx2_kernel();
CountingKernel* neon_kernel();

}  // namespace reorient

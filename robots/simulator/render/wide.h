// SPDX-License-Identifier: MIT
// Loops over pixels, compiled twice: for every processor, and for those that take eight numbers at a time. Each number
// has the same bits from both, since products and sums are never fused and nothing is summed up across lanes.
#pragma once

// Sanitizers want to be started before the choice is made, when the program is loaded.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define REORIENT_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define REORIENT_WIDE
#endif

namespace reorient {

/// Pixels that are looked at together.
inline constexpr int kLanes = 8;

}  // namespace reorient

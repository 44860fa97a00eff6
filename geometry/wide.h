// SPDX-License-Identifier: MIT
// REORIENT_WIDE compiles loops over pixels twice: for all processors, and for those with AVX2 (eight numbers at once).
// Both versions give the same bits, because products and sums are never fused and no sum runs across lanes.
#pragma once

// Not with sanitizers: the program selects a version while it is loaded, before a sanitizer has started.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define REORIENT_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define REORIENT_WIDE
#endif

namespace reorient {

/// Number of pixels that are processed together.
inline constexpr int kLanes = 8;

}  // namespace reorient

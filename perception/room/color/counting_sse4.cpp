// SPDX-License-Identifier: MIT
// Compiled for SSE4.2, independent of the rest of the program (../CMakeLists.txt).
#include "perception/room/color/counting_kernels.h"

#ifdef __SSE4_2__

#include <nmmintrin.h>

#include "perception/room/color/wide_counting.h"

namespace reorient {
namespace {

struct Sse4 {
  using Register = __m128i;
  static constexpr int kPixels = 16;

  static Register load(const std::uint8_t* bytes) { return _mm_loadu_si128(reinterpret_cast<const Register*>(bytes)); }
  static Register table(const std::uint8_t* bytes) { return load(bytes); }
  static Register all(int value) { return _mm_set1_epi8(static_cast<char>(value)); }
  static Register all16(int value) { return _mm_set1_epi16(static_cast<short>(value)); }

  static Register plus(Register a, Register b) { return _mm_add_epi8(a, b); }
  static Register minus(Register a, Register b) { return _mm_sub_epi8(a, b); }
  static Register both(Register a, Register b) { return _mm_and_si128(a, b); }
  static Register either(Register a, Register b) { return _mm_or_si128(a, b); }
  static Register at_least(Register a, Register b) { return _mm_cmpeq_epi8(_mm_max_epu8(a, b), a); }
  /// Elements of b where the mask is set.
  static Register choose(Register a, Register b, Register mask) { return _mm_blendv_epi8(a, b, mask); }
  static Register lookup(Register table, Register indices) { return _mm_shuffle_epi8(table, indices); }
  static Register neighbors_swapped(Register a) {
    return _mm_shuffle_epi8(a, _mm_setr_epi8(1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13, 12, 15, 14));
  }
  static Register high_bytes(Register a) { return _mm_srli_epi16(a, 8); }
  static Register high_nibbles(Register a) { return _mm_srli_epi16(a, 4); }

  static Register packed(Register a, Register b) { return _mm_packus_epi16(a, b); }
  static Register halves(const std::uint8_t* a, const std::uint8_t* b) {
    return _mm_unpacklo_epi64(_mm_loadl_epi64(reinterpret_cast<const Register*>(a)),
                              _mm_loadl_epi64(reinterpret_cast<const Register*>(b)));
  }

  /// Adds the sums of the bytes of each register to four counts.
  static void add_sums(Register a, Register b, Register c, Register d, std::uint32_t* counts) {
    const Register zero = _mm_setzero_si128();
    const Register low = _mm_or_si128(_mm_sad_epu8(a, zero), _mm_slli_epi64(_mm_sad_epu8(b, zero), 16));
    const Register high =
        _mm_or_si128(_mm_slli_epi64(_mm_sad_epu8(c, zero), 32), _mm_slli_epi64(_mm_sad_epu8(d, zero), 48));
    const Register halves = _mm_or_si128(low, high);
    const Register sums = _mm_cvtepu16_epi32(_mm_add_epi16(halves, _mm_unpackhi_epi64(halves, halves)));
    Register* four = reinterpret_cast<Register*>(counts);
    _mm_storeu_si128(four, _mm_add_epi32(_mm_loadu_si128(four), sums));
  }
};

}  // namespace

CountingKernel* sse4_kernel() { return count_wide<Sse4>; }

}  // namespace reorient

#else

namespace reorient {

CountingKernel* sse4_kernel() { return nullptr; }

}  // namespace reorient

#endif

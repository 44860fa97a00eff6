// SPDX-License-Identifier: MIT
// Compiled for AVX2, independent of the rest of the program (../CMakeLists.txt).
#include "perception/room/color/counting_kernels.h"

#ifdef __AVX2__

#include <immintrin.h>

#include "perception/room/color/wide_counting.h"

namespace reorient {
namespace {

struct Avx2 {
  using Register = __m256i;
  static constexpr int kPixels = 32;

  static Register load(const std::uint8_t* bytes) {
    return _mm256_loadu_si256(reinterpret_cast<const Register*>(bytes));
  }
  /// The table is in both halves, since each half has its own lookup.
  static Register table(const std::uint8_t* bytes) {
    return _mm256_broadcastsi128_si256(_mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes)));
  }
  static Register all(int value) { return _mm256_set1_epi8(static_cast<char>(value)); }
  static Register all16(int value) { return _mm256_set1_epi16(static_cast<short>(value)); }

  static Register plus(Register a, Register b) { return _mm256_add_epi8(a, b); }
  static Register minus(Register a, Register b) { return _mm256_sub_epi8(a, b); }
  static Register both(Register a, Register b) { return _mm256_and_si256(a, b); }
  static Register either(Register a, Register b) { return _mm256_or_si256(a, b); }
  static Register at_least(Register a, Register b) { return _mm256_cmpeq_epi8(_mm256_max_epu8(a, b), a); }
  /// Elements of b where the mask is set.
  static Register choose(Register a, Register b, Register mask) { return _mm256_blendv_epi8(a, b, mask); }
  static Register lookup(Register table, Register indices) { return _mm256_shuffle_epi8(table, indices); }
  static Register neighbors_swapped(Register a) {
    const __m128i swap = _mm_setr_epi8(1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13, 12, 15, 14);
    return _mm256_shuffle_epi8(a, _mm256_broadcastsi128_si256(swap));
  }
  static Register high_bytes(Register a) { return _mm256_srli_epi16(a, 8); }
  static Register high_nibbles(Register a) { return _mm256_srli_epi16(a, 4); }

  /// Half by half: eight bytes of a, eight of b, the next eight of a, the next of b.
  static Register packed(Register a, Register b) { return _mm256_packus_epi16(a, b); }
  static Register halves(const std::uint8_t* a, const std::uint8_t* b) {
    const Register one = _mm256_castsi128_si256(_mm_loadu_si128(reinterpret_cast<const __m128i*>(a)));
    const __m128i other = _mm_loadu_si128(reinterpret_cast<const __m128i*>(b));
    return _mm256_permute4x64_epi64(_mm256_inserti128_si256(one, other, 1), 0b11'01'10'00);
  }

  /// Adds the sums of the bytes of each register to four counts.
  static void add_sums(Register a, Register b, Register c, Register d, std::uint32_t* counts) {
    const Register zero = _mm256_setzero_si256();
    const Register low = _mm256_or_si256(_mm256_sad_epu8(a, zero), _mm256_slli_epi64(_mm256_sad_epu8(b, zero), 16));
    const Register high = _mm256_or_si256(_mm256_slli_epi64(_mm256_sad_epu8(c, zero), 32),
                                          _mm256_slli_epi64(_mm256_sad_epu8(d, zero), 48));
    const Register quarters = _mm256_or_si256(low, high);
    const __m128i halves = _mm_add_epi16(_mm256_castsi256_si128(quarters), _mm256_extracti128_si256(quarters, 1));
    const __m128i sums = _mm_cvtepu16_epi32(_mm_add_epi16(halves, _mm_unpackhi_epi64(halves, halves)));
    __m128i* four = reinterpret_cast<__m128i*>(counts);
    _mm_storeu_si128(four, _mm_add_epi32(_mm_loadu_si128(four), sums));
  }
};

}  // namespace

CountingKernel* avx2_kernel() { return count_wide<Avx2>; }

}  // namespace reorient

#else

namespace reorient {

CountingKernel* avx2_kernel() { return nullptr; }

}  // namespace reorient

#endif

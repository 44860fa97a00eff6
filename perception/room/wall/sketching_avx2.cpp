// SPDX-License-Identifier: MIT
// Compiled for AVX2, independent of the rest of the program (../CMakeLists.txt).
#include "perception/room/wall/sketching_kernels.h"

#ifdef __AVX2__

#include <immintrin.h>

#include "perception/room/wall/wide_sketching.h"

namespace reorient {
namespace {

struct Avx2 {
  using Register = __m256;
  static constexpr int kRays = 8;

  static Register load(const float* numbers) { return _mm256_loadu_ps(numbers); }
  static void store(Register a, float* numbers) { _mm256_storeu_ps(numbers, a); }
  /// Truncated toward zero.
  static void store_whole(Register a, int* numbers) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(numbers), _mm256_cvttps_epi32(a));
  }
  static Register all(float value) { return _mm256_set1_ps(value); }
  static Register absolute(Register a) { return _mm256_andnot_ps(all(-0.0f), a); }
  static Register floor(Register a) { return _mm256_floor_ps(a); }
  static Register root(Register a) { return _mm256_sqrt_ps(a); }
  static Register greater_of(Register a, Register b) { return _mm256_max_ps(a, b); }
  static Register lesser_of(Register a, Register b) { return _mm256_min_ps(a, b); }
  static Register less(Register a, Register b) { return _mm256_cmp_ps(a, b, _CMP_LT_OQ); }
  static Register both(Register a, Register b) { return _mm256_and_ps(a, b); }
  /// Elements of b where the mask is set.
  static Register choose(Register a, Register b, Register mask) { return _mm256_blendv_ps(a, b, mask); }
};

}  // namespace

SketchingKernel* avx2_sketching() { return sketch_wide<Avx2>; }

}  // namespace reorient

#else

namespace reorient {

SketchingKernel* avx2_sketching() { return nullptr; }

}  // namespace reorient

#endif

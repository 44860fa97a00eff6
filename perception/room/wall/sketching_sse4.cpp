// SPDX-License-Identifier: MIT
// Compiled for SSE4.2, independent of the rest of the program (../CMakeLists.txt).
#include "perception/room/wall/sketching_kernels.h"

#ifdef __SSE4_2__

#include <nmmintrin.h>

#include "perception/room/wall/wide_sketching.h"

namespace reorient {
namespace {

struct Sse4 {
  using Register = __m128;
  static constexpr int kRays = 4;

  static Register load(const float* numbers) { return _mm_loadu_ps(numbers); }
  static void store(Register a, float* numbers) { _mm_storeu_ps(numbers, a); }
  /// Truncated toward zero.
  static void store_whole(Register a, int* numbers) {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(numbers), _mm_cvttps_epi32(a));
  }
  static Register all(float value) { return _mm_set1_ps(value); }
  static Register absolute(Register a) { return _mm_andnot_ps(all(-0.0f), a); }
  static Register floor(Register a) { return _mm_floor_ps(a); }
  static Register root(Register a) { return _mm_sqrt_ps(a); }
  static Register greater_of(Register a, Register b) { return _mm_max_ps(a, b); }
  static Register lesser_of(Register a, Register b) { return _mm_min_ps(a, b); }
  static Register less(Register a, Register b) { return _mm_cmplt_ps(a, b); }
  static Register both(Register a, Register b) { return _mm_and_ps(a, b); }
  /// Elements of b where the mask is set.
  static Register choose(Register a, Register b, Register mask) { return _mm_blendv_ps(a, b, mask); }
};

}  // namespace

SketchingKernel* sse4_sketching() { return sketch_wide<Sse4>; }

}  // namespace reorient

#else

namespace reorient {

SketchingKernel* sse4_sketching() { return nullptr; }

}  // namespace reorient

#endif

// SPDX-License-Identifier: MIT
// Every 64-bit ARM processor has NEON.
#include "perception/room/wall/sketching_kernels.h"

#ifdef __aarch64__

#include <arm_neon.h>

#include "perception/room/wall/wide_sketching.h"

namespace reorient {
namespace {

struct Neon {
  using Register = float32x4_t;
  static constexpr int kRays = 4;

  static Register load(const float* numbers) { return vld1q_f32(numbers); }
  static void store(Register a, float* numbers) { vst1q_f32(numbers, a); }
  /// Truncated toward zero.
  static void store_whole(Register a, int* numbers) { vst1q_s32(numbers, vcvtq_s32_f32(a)); }
  static Register all(float value) { return vdupq_n_f32(value); }
  static Register absolute(Register a) { return vabsq_f32(a); }
  static Register floor(Register a) { return vrndmq_f32(a); }
  static Register root(Register a) { return vsqrtq_f32(a); }
  // By comparison, so that NaN gives the same result as on x86.
  static Register greater_of(Register a, Register b) { return vbslq_f32(vcgtq_f32(a, b), a, b); }
  static Register lesser_of(Register a, Register b) { return vbslq_f32(vcltq_f32(a, b), a, b); }
  static Register less(Register a, Register b) { return vreinterpretq_f32_u32(vcltq_f32(a, b)); }
  static Register both(Register a, Register b) {
    return vreinterpretq_f32_u32(vandq_u32(vreinterpretq_u32_f32(a), vreinterpretq_u32_f32(b)));
  }
  /// Elements of b where the mask is set.
  static Register choose(Register a, Register b, Register mask) { return vbslq_f32(vreinterpretq_u32_f32(mask), b, a); }
};

}  // namespace

SketchingKernel* neon_sketching() { return sketch_wide<Neon>; }

}  // namespace reorient

#else

namespace reorient {

SketchingKernel* neon_sketching() { return nullptr; }

}  // namespace reorient

#endif

// SPDX-License-Identifier: MIT
// Every 64-bit ARM processor has NEON.
#include "perception/room/color/counting_kernels.h"

#ifdef __aarch64__

#include <arm_neon.h>

#include "perception/room/color/wide_counting.h"

namespace reorient {
namespace {

struct Neon {
  using Register = uint8x16_t;
  static constexpr int kPixels = 16;

  static Register load(const std::uint8_t* bytes) { return vld1q_u8(bytes); }
  static Register table(const std::uint8_t* bytes) { return load(bytes); }
  static Register all(int value) { return vdupq_n_u8(static_cast<std::uint8_t>(value)); }
  static Register all16(int value) { return vreinterpretq_u8_u16(vdupq_n_u16(static_cast<std::uint16_t>(value))); }

  static Register plus(Register a, Register b) { return vaddq_u8(a, b); }
  static Register minus(Register a, Register b) { return vsubq_u8(a, b); }
  static Register both(Register a, Register b) { return vandq_u8(a, b); }
  static Register either(Register a, Register b) { return vorrq_u8(a, b); }
  static Register at_least(Register a, Register b) { return vcgeq_u8(a, b); }
  /// Elements of b where the mask is set.
  static Register choose(Register a, Register b, Register mask) { return vbslq_u8(mask, b, a); }
  /// 0 for indices of 16 and above. x86 only tests the highest bit. No other indices occur.
  static Register lookup(Register table, Register indices) { return vqtbl1q_u8(table, indices); }
  static Register neighbors_swapped(Register a) { return vrev16q_u8(a); }
  static Register high_bytes(Register a) { return vreinterpretq_u8_u16(vshrq_n_u16(vreinterpretq_u16_u8(a), 8)); }
  static Register high_nibbles(Register a) { return vshrq_n_u8(a, 4); }

  /// The low bytes of a, then those of b. Their high bytes are 0.
  static Register packed(Register a, Register b) { return vuzp1q_u8(a, b); }
  static Register halves(const std::uint8_t* a, const std::uint8_t* b) { return vcombine_u8(vld1_u8(a), vld1_u8(b)); }

  /// Adds the sums of the bytes of each register to four counts.
  static void add_sums(Register a, Register b, Register c, Register d, std::uint32_t* counts) {
    const uint16x8_t halves = vpaddq_u16(vpaddlq_u8(a), vpaddlq_u8(b));
    const uint16x8_t more = vpaddq_u16(vpaddlq_u8(c), vpaddlq_u8(d));
    vst1q_u32(counts, vpadalq_u16(vld1q_u32(counts), vpaddq_u16(halves, more)));
  }
};

}  // namespace

CountingKernel* neon_kernel() { return count_wide<Neon>; }

}  // namespace reorient

#else

namespace reorient {

CountingKernel* neon_kernel() { return nullptr; }

}  // namespace reorient

#endif

// SPDX-License-Identifier: MIT
// Included before everything else if the target is 64-bit ARM (cmake/targets.cmake). Empty elsewhere. On ARM, Eigen
// uses registers of two floats, which x86-64 does not have. It then adds three floats in another order: (a + b) + c
// instead of a + (b + c). The last bit differs, then an image, then the digest. This file leaves only registers of four
// floats to Eigen 3.4, as on x86-64.
#pragma once

#if defined(__aarch64__) && __has_include(<Eigen/Core>)

#include <Eigen/Core>

namespace Eigen::internal {

template <int Size>
struct find_best_packet_helper<Size, Packet4f, false> {
  using type = Packet4f;
};

}  // namespace Eigen::internal

#endif

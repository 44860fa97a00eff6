// SPDX-License-Identifier: MIT
// Included before everything else where we compile for 64-bit ARM (cmake/targets.cmake); elsewhere it is empty. Eigen
// takes registers of two floats there, which x86-64 has not, and so adds three floats in another order: (a + b) + c
// instead of a + (b + c). The last bit differs, then an image, then the digest. This leaves Eigen 3.4 the registers of
// four alone, as on x86-64.
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

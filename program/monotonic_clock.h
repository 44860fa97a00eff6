// SPDX-License-Identifier: MIT
// The monotonic clock of Linux, which is never adjusted: used by LoLA's packets, V4L2's images, and for waiting.
#pragma once

#include <chrono>

namespace reorient {

/// s; for differences, and to compare with time stamps of CLOCK_MONOTONIC, which is std::chrono::steady_clock here.
inline double monotonic_clock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace reorient

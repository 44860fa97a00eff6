// SPDX-License-Identifier: MIT
// The clock that is never set, as Linux calls it: of LoLA's packets, of V4L2's images, of whatever waits.
#pragma once

#include <chrono>

namespace reorient {

/// s; of use for differences, and against time stamps of CLOCK_MONOTONIC, which is std::chrono::steady_clock here.
inline double monotonic_clock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace reorient

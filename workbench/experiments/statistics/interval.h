// SPDX-License-Identifier: MIT
// The interval of a quantity.
#pragma once

namespace reorient {

/// Two-sided, 95 %: 2.5 % beyond each bound.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

inline constexpr double kConfidence = 0.95;
inline constexpr double kTail = (1.0 - kConfidence) / 2.0;    ///< beyond each bound
inline constexpr double kNormalQuantile = 1.959963984540054;  ///< of 0.975

}  // namespace reorient

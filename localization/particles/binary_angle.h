// SPDX-License-Identifier: MIT
// Angles as whole numbers: 2^32 steps a turn, so that they wrap by themselves and half a turn is exact. A particle and
// its reflection are therefore weighed bit for bit alike, and a flip done twice is the identity.
#pragma once

#include <cmath>
#include <cstdint>

#include "geometry/angle.h"

namespace reorient {

using BinaryAngle = std::uint32_t;

inline constexpr BinaryAngle kHalfTurn = 0x80000000u;
inline constexpr double kBinaryAnglesPerRadian = 2147483648.0 / kPi;

/// For any finite angle in radians.
inline BinaryAngle to_binary_angle(double radians) {
  const double steps = std::remainder(radians, 2.0 * kPi) * kBinaryAnglesPerRadian;
  return static_cast<BinaryAngle>(static_cast<std::int64_t>(std::nearbyint(steps)));
}

/// Radians in [-pi, pi).
inline double to_radians(BinaryAngle angle) {
  return static_cast<double>(static_cast<std::int32_t>(angle)) / kBinaryAnglesPerRadian;
}

/// Within 2e-7 of the truth; sine(angle + kHalfTurn) == -sine(angle) exactly. Without branches, for the vectoriser.
inline float sine(BinaryAngle angle) {
  const bool behind = ((angle + 0x40000000u) & kHalfTurn) != 0;
  const BinaryAngle folded = behind ? kHalfTurn - angle : angle;  // sin(pi - a) = sin(a)
  const float a =
      static_cast<float>(static_cast<std::int32_t>(folded)) * static_cast<float>(1.0 / kBinaryAnglesPerRadian);
  const float square = a * a;
  // Of all polynomials with these powers the one whose greatest error is the smallest: below 5e-9, without rounding.
  return a * (1.0f + square * (-1.66666571e-1f +
                               square * (8.33301729e-3f + square * (-1.98066152e-4f + square * 2.60005477e-6f))));
}

inline float cosine(BinaryAngle angle) { return sine(angle + 0x40000000u); }

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Angles as integers with 2^32 steps per turn, so that they wrap automatically and half a turn is exact. Therefore a
// particle and its reflection get exactly the same weight, and two flips are the identity.
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

/// Error at most 2e-7; sine(angle + kHalfTurn) == -sine(angle) exactly. Without branches, so that it can be vectorized.
inline float sine(BinaryAngle angle) {
  const bool behind = ((angle + 0x40000000u) & kHalfTurn) != 0;
  const BinaryAngle folded = behind ? kHalfTurn - angle : angle;  // sin(pi - a) = sin(a)
  const float a =
      static_cast<float>(static_cast<std::int32_t>(folded)) * static_cast<float>(1.0 / kBinaryAnglesPerRadian);
  const float square = a * a;
  // The minimax polynomial with these powers: error below 5e-9, without rounding.
  return a * (1.0f + square * (-1.66666571e-1f +
                               square * (8.33301729e-3f + square * (-1.98066152e-4f + square * 2.60005477e-6f))));
}

inline float cosine(BinaryAngle angle) { return sine(angle + 0x40000000u); }

}  // namespace reorient

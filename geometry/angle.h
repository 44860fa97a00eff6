// SPDX-License-Identifier: MIT
// Angles in radians, normalized to (-pi, pi].
#pragma once

#include <cmath>
#include <numbers>

namespace reorient {

inline constexpr double kPi = std::numbers::pi;

constexpr double from_degrees(double degrees) { return degrees * (kPi / 180.0); }
constexpr double to_degrees(double radians) { return radians * (180.0 / kPi); }

/// The same direction in (-pi, pi].
inline double normalize_angle(double angle) {
  // For angles within 1.5 turns the remainder is a plain difference. That is exact, so the bits are the same as below,
  // at a tenth of the time.
  const double size = std::abs(angle);
  if (size < kPi) return angle;
  if (size > kPi && size < 3.0 * kPi) {
    const double turned = size - 2.0 * kPi;
    return angle < 0.0 ? -turned : turned;
  }
  const double turned = std::remainder(angle, 2.0 * kPi);  // in [-pi, pi]
  return turned <= -kPi ? kPi : turned;
}

/// The shortest rotation from `from` to `to`, in (-pi, pi].
inline double angle_difference(double to, double from) { return normalize_angle(to - from); }

}  // namespace reorient

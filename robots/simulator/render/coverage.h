// SPDX-License-Identifier: MIT
// Fraction of a pixel that a thing covers, along one axis.
#pragma once

namespace reorient {

/// Fraction of [center - half, center + half] that lies in [low, high], in [0, 1].
inline float covered_fraction(float center, float half, float low, float high) {
  const float from = center - half > low ? center - half : low;
  const float to = center + half < high ? center + half : high;
  const float inside = to - from;
  return inside > 0.0f ? inside / (2.0f * half) : 0.0f;
}

}  // namespace reorient

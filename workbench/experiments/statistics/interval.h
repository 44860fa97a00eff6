// Between which bounds a quantity lies.
#pragma once

namespace reorient {

/// Two-sided, 95 %: 2.5 % beyond each bound.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

inline constexpr double kConfidence = 0.95;

}  // namespace reorient

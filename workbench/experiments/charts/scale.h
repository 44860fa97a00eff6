// SPDX-License-Identifier: MIT
// From numbers to places on paper.
#pragma once

#include <vector>

namespace reorient {

/// Linear, or logarithmic. Places may run backwards, as those of an ordinate do.
struct Scale {
  double low = 0.0;    ///< number
  double high = 1.0;   ///< another one
  double begin = 0.0;  ///< place of `low`
  double end = 1.0;    ///< place of `high`
  bool logarithmic = false;

  double operator()(double number) const;
};

/// About `wanted` of 1, 2 or 5 times a power of ten, all within the bounds; `low` < `high`.
std::vector<double> ticks(double low, double high, int wanted);

/// 1, 2 and 5 times powers of ten within the bounds, 0 < `low` < `high`.
std::vector<double> logarithmic_ticks(double low, double high);

/// How many decimal digits distinguish such ticks.
int tick_digits(const std::vector<double>& ticks);

/// The least bound from `high` > 0 on that is a tick itself.
double round_up_to_tick(double high, int wanted);

}  // namespace reorient

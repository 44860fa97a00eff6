// SPDX-License-Identifier: MIT
// Converts numbers to positions in a drawing.
#pragma once

#include <vector>

namespace reorient {

/// Linear, logarithmic, or logarithmic at both ends and linear around 0. Positions may decrease, as those of an
/// ordinate do.
struct Scale {
  double low = 0.0;    ///< number
  double high = 1.0;   ///< number
  double begin = 0.0;  ///< position of `low`
  double end = 1.0;    ///< position of `high`
  bool logarithmic = false;
  double linear = 0.0;  ///< if above 0: linear up to about this number, and logarithmic beyond it

  double operator()(double number) const;
};

/// About `wanted` ticks at 1, 2 or 5 times a power of ten, all within the bounds; `low` < `high`.
std::vector<double> ticks(double low, double high, int wanted);

/// 1, 2 and 5 times powers of ten within the bounds, 0 < `low` < `high`.
std::vector<double> logarithmic_ticks(double low, double high);

/// 0, and 10, 100, ... with both signs within the bounds, `low` <= 0 <= `high`.
std::vector<double> signed_ticks(double low, double high);

/// Number of decimal digits that distinguish such ticks.
int tick_digits(const std::vector<double>& ticks);

/// The smallest bound that is a tick and at least `high` > 0.
double round_up_to_tick(double high, int wanted);

}  // namespace reorient

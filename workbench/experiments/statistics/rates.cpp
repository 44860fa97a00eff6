// SPDX-License-Identifier: MIT
#include "workbench/experiments/statistics/rates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/pinned_math.h"

namespace reorient {
namespace {

/// The probability of at most `events` events if `mean` are expected.
double poisson_cumulative(int events, double mean) {
  double logarithm = -mean;  // of one term, because the terms themselves may underflow
  double sum = pinned::exp(logarithm);
  for (int i = 1; i <= events; ++i) {
    logarithm += pinned::log(mean / i);
    sum += pinned::exp(logarithm);
  }
  return sum;
}

/// The mean at which at most `events` have the probability `share`.
double poisson_mean(int events, double share) {
  double low = 0.0, high = 10.0 + 2.0 * events + 10.0 * std::sqrt(static_cast<double>(events));
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (poisson_cumulative(events, middle) > share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

Interval wilson_interval(int events, int trials) {
  if (trials == 0) return {0.0, 1.0};
  const double n = trials, share = events / n, squared = kNormalQuantile * kNormalQuantile;
  const double center = (share + squared / (2.0 * n)) / (1.0 + squared / n);
  const double half =
      kNormalQuantile / (1.0 + squared / n) * std::sqrt(share * (1.0 - share) / n + squared / (4.0 * n * n));
  // Rounding must not give an impossible rate.
  return {events == 0 ? 0.0 : center - half, events == trials ? 1.0 : center + half};
}

Interval poisson_interval(int events) {
  return {events == 0 ? 0.0 : poisson_mean(events - 1, 1.0 - kTail), poisson_mean(events, kTail)};
}

Interval poisson_rate(int events, double exposure) {
  if (exposure <= 0.0) return {0.0, std::numeric_limits<double>::infinity()};
  const Interval expected = poisson_interval(events);
  return {expected.low / exposure, expected.high / exposure};
}

}  // namespace reorient

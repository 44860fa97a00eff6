// SPDX-License-Identifier: MIT
#include "workbench/experiments/statistics/times.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/pinned_math.h"
#include "geometry/random.h"

namespace reorient {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr int kResamples = 2000;

/// `variance`: Greenwood's sum, the relative variance of the fraction.
Interval log_log_band(double share, double variance, const Interval& before) {
  if (share <= 0.0) return {0.0, before.high};
  const double logarithm = pinned::log(share);
  const double spread = pinned::exp(kNormalQuantile * std::sqrt(variance) / -logarithm);
  return {pinned::exp(logarithm * spread), pinned::exp(logarithm / spread)};
}

template <typename Statistic>
Interval bootstrap(const std::vector<double>& values, std::uint64_t seed, Statistic&& statistic) {
  if (values.empty()) return {kUnknown, kUnknown};
  Random random(seed, 0xB0075);
  std::vector<double> results, sample(values.size());
  results.reserve(kResamples);
  for (int i = 0; i < kResamples; ++i) {
    for (double& drawn : sample) drawn = values[random.below(values.size())];
    results.push_back(statistic(sample));
  }
  return {quantile(results, kTail), quantile(results, 1.0 - kTail)};
}

}  // namespace

std::vector<SurvivalStep> kaplan_meier(std::vector<CensoredTime> times) {
  std::sort(times.begin(), times.end(), [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
  std::vector<SurvivalStep> curve;
  double share = 1.0, variance = 0.0;
  Interval band{1.0, 1.0};
  for (std::size_t i = 0; i < times.size();) {
    const double now = times[i].seconds;
    const auto at_risk = static_cast<int>(times.size() - i);
    int events = 0;
    for (; i < times.size() && times[i].seconds == now; ++i) events += times[i].happened ? 1 : 0;
    if (events == 0) continue;
    share *= 1.0 - static_cast<double>(events) / at_risk;
    variance += static_cast<double>(events) / (static_cast<double>(at_risk) * (at_risk - events));
    band = log_log_band(share, variance, band);
    curve.push_back({now, share, at_risk, band});
  }
  return curve;
}

double time_by_which(const std::vector<SurvivalStep>& curve, double share) {
  constexpr double kRounding = 1e-12;
  for (const SurvivalStep& step : curve) {
    if (1.0 - step.share >= share - kRounding) return step.seconds;
  }
  return kUnknown;
}

double mean(const std::vector<double>& values) {
  if (values.empty()) return kUnknown;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return kUnknown;
  std::sort(values.begin(), values.end());
  const double rank = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (rank - static_cast<double>(below)) * (values[above] - values[below]);
}

Interval bootstrap_interval(const std::vector<double>& values, std::uint64_t seed) {
  return bootstrap(values, seed, [](const std::vector<double>& sample) { return mean(sample); });
}

Interval bootstrap_median_interval(const std::vector<double>& values, std::uint64_t seed) {
  return bootstrap(values, seed, [](const std::vector<double>& sample) { return quantile(sample, 0.5); });
}

}  // namespace reorient

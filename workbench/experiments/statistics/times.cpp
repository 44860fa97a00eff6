#include "workbench/experiments/statistics/times.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/random.h"

namespace reorient {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr int kResamples = 2000;

}  // namespace

std::vector<SurvivalStep> kaplan_meier(std::vector<CensoredTime> times) {
  std::sort(times.begin(), times.end(), [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
  std::vector<SurvivalStep> curve;
  double share = 1.0;
  for (std::size_t i = 0; i < times.size();) {
    const double now = times[i].seconds;
    const auto at_risk = static_cast<int>(times.size() - i);
    int events = 0;
    for (; i < times.size() && times[i].seconds == now; ++i) events += times[i].happened ? 1 : 0;
    if (events == 0) continue;
    share *= 1.0 - static_cast<double>(events) / at_risk;
    curve.push_back({now, share, at_risk});
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
  if (values.empty()) return {kUnknown, kUnknown};
  Random random(seed, 0xB0075);
  std::vector<double> means;
  means.reserve(kResamples);
  for (int i = 0; i < kResamples; ++i) {
    double sum = 0.0;
    for (std::size_t draw = 0; draw < values.size(); ++draw) sum += values[random.below(values.size())];
    means.push_back(sum / static_cast<double>(values.size()));
  }
  constexpr double kTail = (1.0 - kConfidence) / 2.0;
  return {quantile(means, kTail), quantile(means, 1.0 - kTail)};
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "workbench/experiments/statistics/roc.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>

#include "geometry/random.h"
#include "workbench/experiments/statistics/times.h"

namespace reorient {

std::vector<RocPoint> roc_curve(std::vector<double> positives, std::vector<double> negatives) {
  if (positives.empty() || negatives.empty()) return {};
  std::sort(positives.begin(), positives.end(), std::greater<>());
  std::sort(negatives.begin(), negatives.end(), std::greater<>());
  std::vector<RocPoint> curve{{0.0, 0.0}};
  std::size_t positive = 0, negative = 0;
  while (positive < positives.size() || negative < negatives.size()) {
    constexpr double kNone = -std::numeric_limits<double>::infinity();
    const double threshold = std::max(positive < positives.size() ? positives[positive] : kNone,
                                      negative < negatives.size() ? negatives[negative] : kNone);
    while (positive < positives.size() && positives[positive] >= threshold) ++positive;
    while (negative < negatives.size() && negatives[negative] >= threshold) ++negative;
    curve.push_back({static_cast<double>(negative) / static_cast<double>(negatives.size()),
                     static_cast<double>(positive) / static_cast<double>(positives.size())});
  }
  return curve;
}

double area_below(const std::vector<RocPoint>& curve) {
  if (curve.empty()) return std::numeric_limits<double>::quiet_NaN();
  double area = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const double width = curve[i].false_positives - curve[i - 1].false_positives;
    area += 0.5 * width * (curve[i].true_positives + curve[i - 1].true_positives);
  }
  return area;
}

double equal_error_rate(const std::vector<RocPoint>& curve) {
  for (std::size_t i = 1; i < curve.size(); ++i) {
    // False alarms less misses: from -1 up to 1.
    const double before = curve[i - 1].false_positives + curve[i - 1].true_positives - 1.0;
    const double now = curve[i].false_positives + curve[i].true_positives - 1.0;
    if (now < 0.0) continue;
    const double share = now > before ? -before / (now - before) : 0.0;
    return curve[i - 1].false_positives + share * (curve[i].false_positives - curve[i - 1].false_positives);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

Interval bootstrap_area_interval(const std::vector<ScoredGroup>& groups, std::uint64_t seed) {
  constexpr int kResamples = 2000;
  constexpr double kUnknownArea = std::numeric_limits<double>::quiet_NaN();
  const std::size_t count = groups.size();
  // won[i * count + j]: how many pairs of a positive of i and a negative of j are in the right order.
  std::vector<double> won(count * count, 0.0);
  for (std::size_t j = 0; j < count; ++j) {
    std::vector<double> negatives = groups[j].negatives;
    std::sort(negatives.begin(), negatives.end());
    for (std::size_t i = 0; i < count; ++i) {
      for (const double positive : groups[i].positives) {
        const auto [below, above] = std::equal_range(negatives.begin(), negatives.end(), positive);
        won[i * count + j] += static_cast<double>(below - negatives.begin()) + 0.5 * static_cast<double>(above - below);
      }
    }
  }
  Random random(seed, 0xB0075);
  std::vector<double> areas, drawn(count);
  areas.reserve(kResamples);
  for (int resample = 0; resample < kResamples && count > 0; ++resample) {
    std::fill(drawn.begin(), drawn.end(), 0.0);
    for (std::size_t i = 0; i < count; ++i) drawn[random.below(count)] += 1.0;
    double pairs_won = 0.0, positives = 0.0, negatives = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      if (drawn[i] == 0.0) continue;
      pairs_won += drawn[i] * std::inner_product(drawn.begin(), drawn.end(), &won[i * count], 0.0);
      positives += drawn[i] * static_cast<double>(groups[i].positives.size());
      negatives += drawn[i] * static_cast<double>(groups[i].negatives.size());
    }
    if (positives > 0.0 && negatives > 0.0) areas.push_back(pairs_won / (positives * negatives));
  }
  if (areas.empty()) return {kUnknownArea, kUnknownArea};
  return {quantile(areas, kTail), quantile(areas, 1.0 - kTail)};
}

}  // namespace reorient

#include "workbench/experiments/statistics/roc.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>

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

}  // namespace reorient

#include "workbench/experiments/statistics/paired_tests.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace reorient {

double mcnemar_p(int only_first, int only_second) {
  const int count = only_first + only_second;
  const int fewer = std::min(only_first, only_second);
  double term = std::ldexp(1.0, -count);  // exact, and 0 beyond a thousand pairs, where the test has long decided
  double sum = 0.0;
  for (int i = 0; i <= fewer; ++i) {
    sum += term;
    term *= static_cast<double>(count - i) / (i + 1);
  }
  return std::min(1.0, 2.0 * sum);
}

double wilcoxon_p(const std::vector<std::pair<double, double>>& pairs) {
  std::vector<double> differences;
  for (const auto& [first, second] : pairs) {
    if (first != second) differences.push_back(first - second);
  }
  std::sort(differences.begin(), differences.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  // Twice the ranks, so that the mean of several is whole.
  std::vector<std::size_t> ranks(differences.size());
  std::size_t total = 0, positive = 0;
  for (std::size_t begin = 0; begin < differences.size();) {
    std::size_t end = begin;
    while (end < differences.size() && std::abs(differences[end]) == std::abs(differences[begin])) ++end;
    for (std::size_t i = begin; i < end; ++i) {
      ranks[i] = begin + 1 + end;
      total += ranks[i];
      positive += differences[i] > 0.0 ? ranks[i] : 0;
    }
    begin = end;
  }
  // With which probability the positive ones add up to each sum, were each sign as likely as the other.
  std::vector<double> probability(total + 1, 0.0);
  probability[0] = 1.0;
  std::size_t reached = 0;
  for (const std::size_t rank : ranks) {
    for (std::size_t sum = reached + 1; sum-- > 0;) {
      probability[sum] *= 0.5;
      probability[sum + rank] += probability[sum];
    }
    reached += rank;
  }
  const std::size_t nearer = std::min(positive, total - positive);
  double tail = 0.0;
  for (std::size_t sum = 0; sum <= nearer; ++sum) tail += probability[sum];
  return std::min(1.0, 2.0 * tail);
}

}  // namespace reorient

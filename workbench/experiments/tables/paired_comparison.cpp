// SPDX-License-Identifier: MIT
#include "workbench/experiments/tables/paired_comparison.h"

#include <map>
#include <utility>

#include "workbench/experiments/statistics/paired_tests.h"
#include "workbench/experiments/statistics/times.h"

namespace reorient {

PairedComparison compare_pairs(const std::vector<Outcome>& first, const std::vector<Outcome>& second) {
  std::map<std::uint64_t, const Outcome*> partners;
  for (const Outcome& outcome : second) partners[outcome.seed] = &outcome;
  PairedComparison comparison;
  std::vector<std::pair<double, double>> times;
  std::vector<double> differences;
  for (const Outcome& one : first) {
    const auto found = partners.find(one.seed);
    if (found == partners.end()) continue;
    const Outcome& other = *found->second;
    ++comparison.pairs;
    if (!one.disturbed || !other.disturbed) continue;
    ++comparison.disturbed;
    comparison.failed_first += one.failed ? 1 : 0;
    comparison.failed_second += other.failed ? 1 : 0;
    comparison.only_first_failed += one.failed && !other.failed ? 1 : 0;
    comparison.only_second_failed += !one.failed && other.failed ? 1 : 0;
    if (!one.right_after || !other.right_after) continue;
    times.emplace_back(*one.right_after, *other.right_after);
    differences.push_back(*other.right_after - *one.right_after);
  }
  comparison.without_pair = static_cast<int>(first.size() + second.size()) - 2 * comparison.pairs;
  comparison.failed_p = mcnemar_p(comparison.only_first_failed, comparison.only_second_failed);
  comparison.times_p = wilcoxon_p(times);
  comparison.timed = static_cast<int>(times.size());
  if (differences.empty()) return comparison;
  comparison.median_difference = quantile(differences, 0.5);
  if (differences.size() > 1) comparison.interval = bootstrap_median_interval(differences);
  return comparison;
}

}  // namespace reorient

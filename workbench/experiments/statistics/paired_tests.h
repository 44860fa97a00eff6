// SPDX-License-Identifier: MIT
// Tests whether two choices with the same seeds differ.
#pragma once

#include <utility>
#include <vector>

namespace reorient {

/// McNemar's exact test: the two-sided probability of such an uneven split of the pairs in which only one trial failed,
/// if both choices were equal. `only_first`, `only_second`: numbers of such pairs.
double mcnemar_p(int only_first, int only_second);

/// Wilcoxon's signed-rank test, exact also for equal differences (each gets their mean rank); ignores pairs without a
/// difference. Two-sided; 1 if no pair differs. With more than 300 pairs that differ, uses the normal approximation.
double wilcoxon_p(const std::vector<std::pair<double, double>>& pairs);

}  // namespace reorient

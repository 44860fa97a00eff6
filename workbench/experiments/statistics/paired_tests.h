// SPDX-License-Identifier: MIT
// Whether two ways differ that were tried on the same seeds.
#pragma once

#include <utility>
#include <vector>

namespace reorient {

/// McNemar's test, exact: the two-sided probability that of the pairs of which only one failed, the failures lie so
/// unevenly, if both conditions were equal. `only_first`, `only_second`: such pairs.
double mcnemar_p(int only_first, int only_second);

/// Wilcoxon's signed-rank test, exact also for equal differences (each gets their mean rank); pairs without a
/// difference say nothing. Two-sided; 1 where no pair differs. Beyond 300 pairs that differ by the normal distribution
/// that the exact one comes near.
double wilcoxon_p(const std::vector<std::pair<double, double>>& pairs);

}  // namespace reorient

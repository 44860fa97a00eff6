// SPDX-License-Identifier: MIT
// Two choices that were run with the same seeds, pair by pair.
#pragma once

#include <optional>
#include <vector>

#include "workbench/experiments/statistics/interval.h"
#include "workbench/experiments/tables/outcome.h"

namespace reorient {

struct PairedComparison {
  int pairs = 0;         ///< seeds that both choices have
  int without_pair = 0;  ///< trials of either choice whose seed the other choice does not have

  // Of the pairs in which both beliefs were wrong at the start:
  int disturbed = 0;
  int failed_first = 0;
  int failed_second = 0;
  int only_first_failed = 0;
  int only_second_failed = 0;
  double failed_p = 1.0;  ///< McNemar's test

  // Of those in which both beliefs were corrected: time until the belief is right, second minus first, s.
  int timed = 0;
  std::optional<double> median_difference;
  std::optional<Interval> interval;  ///< of that median, by bootstrap; empty with fewer than two pairs
  double times_p = 1.0;              ///< Wilcoxon's test
};

/// The seeds within each choice must differ.
PairedComparison compare_pairs(const std::vector<Outcome>& first, const std::vector<Outcome>& second);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Two choices with the same seeds.
#include "workbench/experiments/tables/paired_comparison.h"

#include <gtest/gtest.h>

#include "workbench/experiments/statistics/paired_tests.h"

namespace reorient {
namespace {

Outcome came_right(std::uint64_t seed, double right_after) { return {seed, true, false, right_after, {}, {}, 0}; }
Outcome came_to_nothing(std::uint64_t seed) { return {seed, true, true, {}, {}, {}, 0}; }
Outcome left_correct(std::uint64_t seed) { return {seed, false, false, 0.1, {}, {}, 0}; }

TEST(PairedComparison, PairsEqualSeedsInAnyOrder) {
  const PairedComparison comparison = compare_pairs({came_right(1, 2.0), came_right(2, 3.0), came_right(3, 4.0)},
                                                    {came_right(3, 1.0), came_right(2, 3.5)});
  EXPECT_EQ(comparison.pairs, 2);
  EXPECT_EQ(comparison.without_pair, 1);
  EXPECT_EQ(comparison.timed, 2);
  EXPECT_EQ(comparison.median_difference, -1.25);
}

TEST(PairedComparison, CountsFailuresOfOneTrialOfAPair) {
  const PairedComparison comparison =
      compare_pairs({came_to_nothing(1), came_to_nothing(2), came_to_nothing(3), came_right(4, 1.0)},
                    {came_right(1, 2.0), came_right(2, 2.0), came_to_nothing(3), came_to_nothing(4)});
  EXPECT_EQ(comparison.failed_first, 3);
  EXPECT_EQ(comparison.failed_second, 2);
  EXPECT_EQ(comparison.only_first_failed, 2);
  EXPECT_EQ(comparison.only_second_failed, 1);
  EXPECT_EQ(comparison.failed_p, mcnemar_p(2, 1));
  EXPECT_FALSE(comparison.median_difference) << "no pair was corrected in both";
}

TEST(PairedComparison, LeavesOutPairsWithAnUndisturbedTrial) {
  const PairedComparison comparison =
      compare_pairs({left_correct(1), came_to_nothing(2)}, {came_to_nothing(1), left_correct(2)});
  EXPECT_EQ(comparison.pairs, 2);
  EXPECT_EQ(comparison.disturbed, 0);
  EXPECT_EQ(comparison.failed_first + comparison.failed_second, 0);
  EXPECT_EQ(comparison.failed_p, 1.0);
}

TEST(PairedComparison, ReportsAConstantDelayWithAnIntervalOfZeroWidth) {
  std::vector<Outcome> first, second;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    first.push_back(came_right(seed, static_cast<double>(seed)));
    second.push_back(came_right(seed, static_cast<double>(seed) + 0.5));
  }
  const PairedComparison comparison = compare_pairs(first, second);
  EXPECT_EQ(comparison.median_difference, 0.5);
  ASSERT_TRUE(comparison.interval);
  EXPECT_EQ(comparison.interval->low, 0.5);
  EXPECT_EQ(comparison.interval->high, 0.5);
  EXPECT_NEAR(comparison.times_p, 2.0 / 256.0, 1e-12);
}

TEST(PairedComparison, OfOnePairHasNoInterval) {
  const PairedComparison comparison = compare_pairs({came_right(1, 2.0)}, {came_right(1, 2.5)});
  EXPECT_EQ(comparison.median_difference, 0.5);
  EXPECT_FALSE(comparison.interval);
}

TEST(PairedComparison, WithoutTrialsHasNoValues) {
  const PairedComparison comparison = compare_pairs({}, {});
  EXPECT_EQ(comparison.pairs, 0);
  EXPECT_EQ(comparison.failed_p, 1.0);
  EXPECT_EQ(comparison.times_p, 1.0);
}

}  // namespace
}  // namespace reorient

// SPDX-License-Identifier: MIT
// Comparison with published values.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "workbench/experiments/statistics/calibration.h"
#include "workbench/experiments/statistics/paired_tests.h"
#include "workbench/experiments/statistics/rates.h"
#include "workbench/experiments/statistics/roc.h"
#include "workbench/experiments/statistics/times.h"

namespace reorient {
namespace {

void expect_interval(const Interval& interval, double low, double high, double tolerance) {
  EXPECT_NEAR(interval.low, low, tolerance);
  EXPECT_NEAR(interval.high, high, tolerance);
}

TEST(WilsonInterval, IsNewcombes) {  // 1998, table I, method 3
  expect_interval(wilson_interval(81, 263), 0.2553, 0.3662, 5e-5);
  expect_interval(wilson_interval(15, 148), 0.0624, 0.1605, 5e-5);
  expect_interval(wilson_interval(0, 20), 0.0, 0.1611, 5e-5);
  expect_interval(wilson_interval(1, 29), 0.0061, 0.1718, 5e-5);
}

TEST(WilsonInterval, IsSymmetricAndCoversEverythingWithoutTrials) {
  expect_interval(wilson_interval(20, 20), 1.0 - 0.1611, 1.0, 5e-5);
  expect_interval(wilson_interval(0, 0), 0.0, 1.0, 0.0);
}

RC_GTEST_PROP(WilsonIntervalProperty, ContainsTheObservedRate, ()) {
  const int trials = *rc::gen::inRange(1, 10'000);
  const int events = *rc::gen::inRange(0, trials + 1);
  const Interval interval = wilson_interval(events, trials);
  const double share = static_cast<double>(events) / trials;
  RC_ASSERT(0.0 <= interval.low && interval.low <= share && share <= interval.high && interval.high <= 1.0);
}

TEST(PoissonInterval, IsGarwoods) {  // 1936; as tabled by Ulm 1990 and others
  expect_interval(poisson_interval(0), 0.0, 3.689, 5e-4);
  expect_interval(poisson_interval(1), 0.0253, 5.572, 5e-4);
  expect_interval(poisson_interval(5), 1.623, 11.668, 5e-4);
  expect_interval(poisson_interval(10), 4.795, 18.390, 5e-4);
  expect_interval(poisson_interval(100), 81.364, 121.627, 5e-3);
}

TEST(PoissonInterval, IsValidForThousandsOfEvents) {
  const Interval interval = poisson_interval(5000);
  EXPECT_NEAR(interval.low, 4862.4, 1.0);
  EXPECT_NEAR(interval.high, 5140.6, 1.0);
}

TEST(PoissonInterval, OfARateIsPerUnitOfExposure) {
  expect_interval(poisson_rate(0, 10.0), 0.0, 0.3689, 5e-5);
  expect_interval(poisson_rate(5, 0.5), 3.246, 23.336, 1e-3);
  EXPECT_TRUE(std::isinf(poisson_rate(0, 0.0).high));
}

TEST(KaplanMeier, IsThePublishedOneForTheLeukemiaTrial) {  // Freireich et al. 1963, weeks in remission under 6-MP
  std::vector<CensoredTime> times;
  for (const double seen : {6, 6, 6, 7, 10, 13, 16, 22, 23}) times.push_back({seen, true});
  for (const double left : {6, 9, 10, 11, 17, 19, 20, 25, 32, 32, 34, 35}) times.push_back({left, false});
  const std::vector<SurvivalStep> curve = kaplan_meier(times);
  const double expected[][3] = {{6, 0.857, 21},  {7, 0.807, 17}, {10, 0.753, 15}, {13, 0.690, 12},
                                {16, 0.627, 11}, {22, 0.538, 7}, {23, 0.448, 6}};
  ASSERT_EQ(curve.size(), std::size(expected));
  for (std::size_t i = 0; i < curve.size(); ++i) {
    EXPECT_EQ(curve[i].seconds, expected[i][0]);
    EXPECT_NEAR(curve[i].share, expected[i][1], 5e-4);
    EXPECT_EQ(curve[i].at_risk, expected[i][2]);
  }
  EXPECT_EQ(time_by_which(curve, 0.5), 23.0);
  EXPECT_TRUE(std::isnan(time_by_which(curve, 0.9)));
}

TEST(KaplanMeier, HasTheBandOfTheLeukemiaTrial) {  // log-log, as Stata's sts list shows it
  std::vector<CensoredTime> times;
  for (const double seen : {6, 6, 6, 7, 10, 13, 16, 22, 23}) times.push_back({seen, true});
  for (const double left : {6, 9, 10, 11, 17, 19, 20, 25, 32, 32, 34, 35}) times.push_back({left, false});
  const std::vector<SurvivalStep> curve = kaplan_meier(times);
  constexpr double kBounds[][2] = {{0.6197, 0.9516}, {0.5631, 0.9228}, {0.5032, 0.8894}, {0.4316, 0.8491},
                                   {0.3675, 0.8049}, {0.2678, 0.7468}, {0.1881, 0.6801}};
  ASSERT_EQ(curve.size(), std::size(kBounds));
  for (std::size_t i = 0; i < curve.size(); ++i) expect_interval(curve[i].band, kBounds[i][0], kBounds[i][1], 1e-4);
}

TEST(KaplanMeier, KeepsItsUpperBoundWhenNoTrialIsLeft) {
  const std::vector<SurvivalStep> curve = kaplan_meier({{1.0, true}, {2.0, true}, {3.0, true}});
  ASSERT_EQ(curve.size(), 3U);
  expect_interval(curve[2].band, 0.0, curve[1].band.high, 0.0);
  expect_interval(kaplan_meier({{1.0, true}})[0].band, 0.0, 1.0, 0.0);
}

TEST(KaplanMeier, WithoutCensoringCountsTheRest) {
  const std::vector<SurvivalStep> curve = kaplan_meier({{3.0, true}, {1.0, true}, {2.0, true}, {2.0, true}});
  ASSERT_EQ(curve.size(), 3U);
  EXPECT_NEAR(curve[1].share, 0.25, 1e-12);
  EXPECT_EQ(time_by_which(curve, 0.75), 2.0);
  EXPECT_TRUE(kaplan_meier({}).empty());
}

TEST(Quantile, IsInterpolatedBetweenRanks) {  // R's quantile(), type 7
  const std::vector<double> values{7.0, 1.0, 3.0, 2.0, 10.0};
  EXPECT_EQ(quantile(values, 0.0), 1.0);
  EXPECT_EQ(quantile(values, 0.5), 3.0);
  EXPECT_NEAR(quantile(values, 0.9), 8.8, 1e-12);
  EXPECT_EQ(quantile(values, 1.0), 10.0);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(BootstrapInterval, IsNearTheNormalOneForManyAndTheSameForOneSeed) {
  std::vector<double> values;
  values.reserve(400);
  for (int i = 0; i < 400; ++i) values.push_back(i % 20);
  const double spread = std::sqrt((400.0 - 1.0) / 12.0 / 400.0);
  const Interval interval = bootstrap_interval(values, 3);
  EXPECT_NEAR(interval.low, mean(values) - 1.96 * spread, 0.1);
  EXPECT_NEAR(interval.high, mean(values) + 1.96 * spread, 0.1);
  EXPECT_EQ(bootstrap_interval(values, 3).low, interval.low);
  EXPECT_NE(bootstrap_interval(values, 4).low, interval.low);
}

TEST(BootstrapInterval, OfOneValueIsThatValue) {
  expect_interval(bootstrap_interval({2.5}), 2.5, 2.5, 0.0);
  EXPECT_TRUE(std::isnan(bootstrap_interval({}).low));
}

TEST(BootstrapInterval, OfAMedianIsRobustAgainstAnOutlier) {
  std::vector<double> values{1e9};
  for (int i = 0; i < 30; ++i) values.push_back(i % 5);
  const Interval interval = bootstrap_median_interval(values);
  EXPECT_GE(interval.low, 1.0);
  EXPECT_LE(interval.high, 3.0);
  EXPECT_TRUE(std::isnan(bootstrap_median_interval({}).high));
}

TEST(McNemar, IsValidForThousandsOfPairs) {
  EXPECT_EQ(mcnemar_p(1500, 1500), 1.0);
  EXPECT_NEAR(mcnemar_p(2450, 2550), 0.1615, 5e-4);  // R's binom.test(2450, 5000)
  EXPECT_EQ(mcnemar_p(0, 5000), 0.0);
}

TEST(McNemar, IsTheTwoSidedBinomialTest) {
  EXPECT_NEAR(mcnemar_p(6, 16), 0.0525, 5e-5);  // R's binom.test(6, 22)
  EXPECT_NEAR(mcnemar_p(16, 6), 0.0525, 5e-5);
  EXPECT_NEAR(mcnemar_p(0, 6), 0.03125, 1e-12);
  EXPECT_EQ(mcnemar_p(0, 0), 1.0);
  EXPECT_EQ(mcnemar_p(5, 5), 1.0);
}

TEST(Wilcoxon, IsExactForTheDepressionStudy) {  // Hollander and Wolfe 1973, page 29
  EXPECT_NEAR(wilcoxon_p({{1.83, 0.878},
                          {0.50, 0.647},
                          {1.62, 0.598},
                          {2.48, 2.05},
                          {1.68, 1.06},
                          {1.88, 1.29},
                          {1.55, 1.06},
                          {3.06, 3.14},
                          {1.30, 1.29}}),
              0.0390625, 1e-9);
}

TEST(Wilcoxon, CountsEqualDifferencesWithTheirMeanRankAndLeavesOutPairsThatDoNotDiffer) {
  // Differences 1, 1, 1, -1: of the 16 ways to give them signs, 10 are as uneven or more.
  EXPECT_NEAR(wilcoxon_p({{2, 1}, {3, 2}, {4, 3}, {1, 2}, {5, 5}}), 10.0 / 16.0, 1e-12);
  EXPECT_EQ(wilcoxon_p({{5, 5}, {6, 6}}), 1.0);
  EXPECT_EQ(wilcoxon_p({}), 1.0);
}

TEST(Wilcoxon, ChangesToTheNormalDistributionWithoutAJump) {
  const auto p = [](int count) {
    std::vector<std::pair<double, double>> pairs;
    for (int i = 1; i <= count; ++i) pairs.emplace_back(0.0, i % 5 < 3 ? i : -i);
    return wilcoxon_p(pairs);
  };
  EXPECT_LT(p(300), 0.01);
  EXPECT_NEAR(p(305), p(300), 2e-4);
  EXPECT_LT(p(5000), 1e-6);
}

RC_GTEST_PROP(WilcoxonProperty, IsSymmetricInBothSamples, (const std::vector<std::pair<int, int>>& values)) {
  std::vector<std::pair<double, double>> pairs, exchanged;
  for (const auto& [first, second] : values) {
    pairs.emplace_back(first, second);
    exchanged.emplace_back(second, first);
  }
  const double p = wilcoxon_p(pairs);
  RC_ASSERT(p > 0.0 && p <= 1.0);
  RC_ASSERT(std::abs(p - wilcoxon_p(exchanged)) < 1e-9);
}

TEST(Calibration, IsPerfectIfProbabilitiesMatchFrequencies) {
  std::vector<double> said(99, std::log(99.0));
  said.push_back(-std::log(99.0));
  const std::vector<CalibrationBin> bins = calibration_bins(said);
  ASSERT_EQ(bins.size(), 1u);
  EXPECT_EQ(bins[0].samples, 100);
  EXPECT_EQ(bins[0].right, 99);
  EXPECT_NEAR(bins[0].certainty(), 0.99, 1e-12);
  EXPECT_NEAR(calibration_error(bins), 0.0, 1e-12);
}

TEST(Calibration, CountsOverconfidenceAndUnderconfidence) {
  const std::vector<double> certain{std::log(9.0), -std::log(9.0)};         // states 90 %, is right in 50 %
  const std::vector<double> timid{std::log(1.5), std::log(1.5), 0.405465};  // states 60 %, is always right
  EXPECT_NEAR(calibration_error(calibration_bins(certain)), 0.4, 1e-9);
  EXPECT_NEAR(calibration_error(calibration_bins(timid)), 0.4, 1e-6);
  std::vector<double> both = certain;
  both.insert(both.end(), timid.begin(), timid.end());
  EXPECT_NEAR(calibration_error(calibration_bins(both)), 0.4, 1e-6) << "they do not balance each other";
}

TEST(Calibration, WithoutProbabilitiesHasNoError) {
  EXPECT_TRUE(calibration_bins({}).empty());
  EXPECT_EQ(calibration_error({}), 0.0);
  const std::vector<double> extremes{1e300, -1e300, 0.0};
  EXPECT_TRUE(std::isfinite(calibration_error(calibration_bins(extremes))));
}

TEST(Roc, IsTheShareOfPairsInTheRightOrder) {
  const std::vector<RocPoint> curve = roc_curve({0.9, 0.8, 0.4}, {0.5, 0.4, 0.1});
  EXPECT_EQ(curve.front().true_positives, 0.0);
  EXPECT_EQ(curve.back().false_positives, 1.0);
  // Of nine pairs seven are in order, one is even.
  EXPECT_NEAR(area_below(curve), 7.5 / 9.0, 1e-12);
  EXPECT_TRUE(std::isnan(area_below(roc_curve({}, {0.5}))));
}

}  // namespace
}  // namespace reorient

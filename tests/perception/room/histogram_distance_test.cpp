// SPDX-License-Identifier: MIT
#include "perception/room/color/histogram_distance.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/perception/room/histograms.h"

namespace reorient {
namespace {

constexpr Distance kAll[] = {Distance::ssd3, Distance::ssd14, Distance::hellinger, Distance::jensen_shannon,
                             Distance::chi_square};
constexpr Distance kBounded[] = {Distance::hellinger, Distance::jensen_shannon, Distance::chi_square};

RC_GTEST_PROP(HistogramDistance, IsZeroToItselfAndNeverNegative, ()) {
  const ColorHistogram a = any_histogram();
  const ColorHistogram b = any_histogram();
  for (const Distance measure : kAll) {
    RC_ASSERT(distance(measure, a, a) < 1e-3);
    RC_ASSERT(distance(measure, a, b) >= 0.0);
  }
}

RC_GTEST_PROP(HistogramDistance, IsSymmetricExceptForTheDominantBins, ()) {
  const ColorHistogram a = any_histogram();
  const ColorHistogram b = any_histogram();
  for (const Distance measure : kAll) {
    if (measure == Distance::ssd3) continue;
    RC_ASSERT(std::abs(distance(measure, a, b) - distance(measure, b, a)) < 1e-6);
  }
  RC_ASSERT(distance(Distance::chi_square, a, b) == distance(Distance::chi_square, b, a));
}

RC_GTEST_PROP(HistogramDistance, IsAtMostOneForAllNormalizedMeasures, ()) {
  const ColorHistogram a = any_histogram();
  const ColorHistogram b = any_histogram();
  for (const Distance measure : kBounded) RC_ASSERT(distance(measure, a, b) <= 1.0 + 1e-6);
}

RC_GTEST_PROP(HistogramDistance, SatisfiesTheTriangleInequalityForAllNormalizedMeasures, ()) {
  const ColorHistogram a = any_histogram();
  const ColorHistogram b = any_histogram();
  const ColorHistogram between = any_histogram();
  for (const Distance measure : kBounded) {
    const double detour = distance(measure, a, between) + distance(measure, between, b);
    RC_ASSERT(distance(measure, a, b) <= detour + 2e-3);  // square roots of rounding errors in single precision
  }
}

/// The bits must be equal, since digests depend on them.
RC_GTEST_PROP(HistogramDistance, ToManyIsTheSameAsOneByOne, ()) {
  const std::size_t count = *rc::gen::inRange<std::size_t>(0, 14);
  for (const Distance measure : kAll) {
    const ComparedHistogram perceived = prepared(measure, any_histogram());
    std::vector<ComparedHistogram> models(count);
    for (ComparedHistogram& model : models) model = prepared(measure, any_histogram());
    std::vector<const ComparedHistogram*> pointers(count);
    for (std::size_t i = 0; i < count; ++i) pointers[i] = &models[i];
    std::vector<double> results(count);
    distances(measure, perceived, pointers, results);
    for (std::size_t i = 0; i < count; ++i) RC_ASSERT(results[i] == distance(measure, perceived, models[i]));
  }
}

TEST(HistogramDistance, IsOneBetweenHistogramsWithNothingInCommon) {
  for (const Distance measure : kBounded) EXPECT_NEAR(distance(measure, all_in(1), all_in(9)), 1.0, 1e-6);
  EXPECT_NEAR(distance(Distance::ssd14, all_in(1), all_in(9)), 2.0, 1e-6);
}

TEST(HistogramDistance, SsdOverThreeBinsUsesTheLargestBinsOfThePerceivedHistogram) {
  ColorHistogram perceived{};
  perceived[4] = 0.4f;
  perceived[7] = 0.3f;
  perceived[9] = 0.2f;
  perceived[10] = 0.1f;
  ColorHistogram model{};
  model[4] = 0.1f;
  model[7] = 0.3f;
  model[13] = 0.6f;
  EXPECT_NEAR(distance(Distance::ssd3, perceived, model), 0.09 + 0.0 + 0.04, 1e-6);
  EXPECT_NEAR(distance(Distance::ssd14, perceived, model), 0.09 + 0.04 + 0.01 + 0.36, 1e-6);
}

TEST(HistogramDistance, MatchesExamples) {
  ColorHistogram half{};
  half[2] = 0.5f;
  half[3] = 0.5f;
  EXPECT_NEAR(distance(Distance::hellinger, half, all_in(2)), std::sqrt(1.0 - std::sqrt(0.5)), 1e-6);
  // Against the mixture (3/4, 1/4): half of log2(4/3) + half of (1/2 log2(2/3) + 1/2 log2 2).
  const double divergence = 0.5 * std::log2(4.0 / 3.0) + 0.25 * std::log2(2.0 / 3.0) + 0.25;
  EXPECT_NEAR(distance(Distance::jensen_shannon, half, all_in(2)), std::sqrt(divergence), 1e-6);
  // Half of (1/4 by 3/2 + 1/4 by 1/2).
  EXPECT_NEAR(distance(Distance::chi_square, half, all_in(2)), std::sqrt(1.0 / 3.0), 1e-6);
}

TEST(HistogramDistance, OfChiSquareHasTheSameBitsEverywhere) {
  ColorHistogram a{}, b{};
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i] = static_cast<float>(i + 1) / 105.0f;
    b[i] = static_cast<float>(14 - i) / 105.0f;
  }
  EXPECT_EQ(distance(Distance::chi_square, a, b), 0x1.13311571fa19fp-1);
}

}  // namespace
}  // namespace reorient

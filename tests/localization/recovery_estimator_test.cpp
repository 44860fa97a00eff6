// SPDX-License-Identifier: MIT
#include "localization/measurement/recovery_estimator.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace reorient {
namespace {

void feed(RecoveryEstimator& estimator, double fit, double seconds) {
  for (int i = 0; i < static_cast<int>(seconds * 30.0); ++i) estimator.update(fit, 1.0 / 30.0, 60.0, 0.7);
}

TEST(RecoveryEstimator, IsNotLostBeforeItHasSeenAnything) {
  EXPECT_EQ(RecoveryEstimator().recovery_probability(0.6), 0.0);
}

TEST(RecoveryEstimator, AcceptsAPoorFitFromTheStartAsUsual) {
  RecoveryEstimator estimator;
  feed(estimator, 0.2, 1.0);
  EXPECT_NEAR(estimator.slow(), 0.2, 1e-9);
  EXPECT_EQ(estimator.recovery_probability(0.6), 0.0);
}

TEST(RecoveryEstimator, IsLostSoonAfterTheFitDrops) {
  RecoveryEstimator estimator;
  feed(estimator, 0.6, 10.0);
  EXPECT_EQ(estimator.recovery_probability(0.6), 0.0);
  feed(estimator, 0.1, 2.0);
  EXPECT_GT(estimator.recovery_probability(0.6), 0.4);
}

TEST(RecoveryEstimator, IsLostImmediatelyAfterADoubtWhenNothingFits) {
  RecoveryEstimator estimator;
  feed(estimator, 0.6, 10.0);
  estimator.doubt();
  EXPECT_EQ(estimator.recovery_probability(0.6), 0.0);
  feed(estimator, 0.1, 0.1);
  EXPECT_GT(estimator.recovery_probability(0.6), 0.4);
}

TEST(RecoveryEstimator, IsNotLostAfterADoubtWhenTheFitIsAsBefore) {
  RecoveryEstimator estimator;
  feed(estimator, 0.6, 10.0);
  estimator.doubt();
  feed(estimator, 0.6, 0.1);
  EXPECT_EQ(estimator.recovery_probability(0.6), 0.0);
}

TEST(RecoveryEstimator, IgnoresASingleBadFrame) {
  RecoveryEstimator estimator;
  feed(estimator, 0.6, 10.0);
  estimator.update(0.0, 1.0 / 30.0, 60.0, 0.7);
  EXPECT_EQ(estimator.recovery_probability(0.6), 0.0);
}

TEST(RecoveryEstimator, ForgetsWhenItIsRestarted) {
  RecoveryEstimator estimator;
  feed(estimator, 0.6, 10.0);
  feed(estimator, 0.1, 2.0);
  estimator.restart();
  EXPECT_EQ(estimator.recovery_probability(0.6), 0.0);
  EXPECT_EQ(estimator.slow(), 0.0);
}

TEST(RecoveryEstimator, IgnoresFramesBetweenWhichNoTimePasses) {
  RecoveryEstimator estimator;
  estimator.update(0.5, 0.0, 60.0, 0.7);
  EXPECT_EQ(estimator.slow(), 0.0);
}

TEST(RecoveryEstimator, RejectsInvalidValuesWhenRead) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {kNaN, -1.0, 2.0}) {
    std::vector<std::byte> bytes;
    ByteWriter writer(bytes);
    writer(1.0, 1.0, 0.5, bad);
    RecoveryEstimator estimator;
    ByteReader reader(bytes);
    EXPECT_THROW(reader(estimator), BadBytes) << bad;
  }
}

}  // namespace
}  // namespace reorient

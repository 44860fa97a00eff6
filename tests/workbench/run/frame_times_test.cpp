// SPDX-License-Identifier: MIT
// Durations of frames in three numbers.
#include "workbench/run/frame_times.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

TEST(FrameTimes, WithoutFramesAreZero) {
  EXPECT_EQ(TimeHistogram().quantiles().longest, 0.0);
  EXPECT_EQ(FrameTimes().whole().median, 0.0);
}

TEST(FrameTimes, OfOneFrameAreItsTimes) {
  TimeHistogram times;
  times.add(0.5);
  EXPECT_EQ(times.quantiles().longest, 0.5);
  EXPECT_NEAR(times.quantiles().median, 0.5, 0.005);
  EXPECT_NEAR(times.quantiles().percentile_99, 0.5, 0.005);
}

TEST(FrameTimes, AreRanksOfTheMeasuredTimes) {
  TimeHistogram times;
  for (int i = 200; i > 0; --i) times.add(1e-3 * i);
  EXPECT_NEAR(times.quantiles().median, 0.100, 0.001);
  EXPECT_NEAR(times.quantiles().percentile_99, 0.198, 0.002);
  EXPECT_EQ(times.quantiles().longest, 0.200);
}

RC_GTEST_PROP(FrameTimesProperty, AreInOrderForAnyTimes, (const std::vector<unsigned>& microseconds)) {
  TimeHistogram times;
  for (const unsigned one : microseconds) times.add(1e-6 * one);
  const TimeQuantiles all = times.quantiles();
  RC_ASSERT(all.median <= all.percentile_99);
  RC_ASSERT(all.percentile_99 <= all.longest);
}

TEST(FrameTimes, SeparateTheEnginesPartFromTheRobots) {
  FrameTimes times;
  SceneTruth scene;
  scene.observing = 2.0;
  scene.stepping = 1.0;
  times.observe(FrameRecord(), scene);
  EXPECT_EQ(times.whole().longest, 3.0);
  EXPECT_EQ(times.without_observing().longest, 1.0);
}

}  // namespace
}  // namespace reorient

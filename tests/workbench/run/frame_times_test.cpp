// How long frames took, in three numbers.
#include "workbench/run/frame_times.h"

#include <gtest/gtest.h>

namespace reorient {
namespace {

TEST(FrameTimes, WithoutFramesAreZero) {
  EXPECT_EQ(quantiles({}).longest, 0.0);
  EXPECT_EQ(FrameTimes().whole().median, 0.0);
}

TEST(FrameTimes, OfOneFrameAreThatFrames) {
  const TimeQuantiles one = quantiles({0.5});
  EXPECT_EQ(one.median, 0.5);
  EXPECT_EQ(one.percentile_99, 0.5);
  EXPECT_EQ(one.longest, 0.5);
}

TEST(FrameTimes, AreRanksOfWhatWasMeasured) {
  std::vector<double> seconds;
  for (int i = 200; i > 0; --i) seconds.push_back(i);
  const TimeQuantiles all = quantiles(seconds);
  EXPECT_EQ(all.median, 100.0);
  EXPECT_EQ(all.percentile_99, 198.0);
  EXPECT_EQ(all.longest, 200.0);
}

TEST(FrameTimes, TellTheEnginesOwnPartFromTheRobots) {
  FrameTimes times;
  times.add(3.0, 2.0);
  EXPECT_EQ(times.whole().longest, 3.0);
  EXPECT_EQ(times.without_observing().longest, 1.0);
}

}  // namespace
}  // namespace reorient

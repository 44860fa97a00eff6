// SPDX-License-Identifier: MIT
#include "perception/room/color/color_histogram.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/perception/room/histograms.h"

namespace reorient {
namespace {

TEST(ColorHistogram, HasTheFourteenRegionsOfTheDefinition) {
  const ColorThresholds thresholds = color_thresholds({});
  EXPECT_EQ(color_bin({20, 128, 128}, thresholds), 0);
  EXPECT_EQ(color_bin({230, 128, 128}, thresholds), 1);
  EXPECT_EQ(color_bin({127, 132, 124}, thresholds), 0);
  EXPECT_EQ(color_bin({128, 124, 132}, thresholds), 1);
  for (int slice = 0; slice < 3; ++slice) {
    const auto luma = static_cast<std::uint8_t>(40 + 85 * slice);
    EXPECT_EQ(color_bin({luma, 100, 100}, thresholds), 2 + 4 * slice);
    EXPECT_EQ(color_bin({luma, 160, 100}, thresholds), 3 + 4 * slice);
    EXPECT_EQ(color_bin({luma, 100, 160}, thresholds), 4 + 4 * slice);
    EXPECT_EQ(color_bin({luma, 160, 160}, thresholds), 5 + 4 * slice);
  }
  EXPECT_EQ(color_bin({84, 100, 100}, thresholds), 2);
  EXPECT_EQ(color_bin({85, 100, 100}, thresholds), 6);
  EXPECT_EQ(color_bin({169, 100, 100}, thresholds), 6);
  EXPECT_EQ(color_bin({170, 100, 100}, thresholds), 10);
  EXPECT_EQ(color_bin({40, 128, 133}, thresholds), 5) << "one chroma value alone is not enough for gray";
}

TEST(ColorHistogram, WithoutPixelsIsAllZero) { EXPECT_EQ(normalized(ColorCounts{}), ColorHistogram{}); }

TEST(ColorHistogram, ThresholdsMoveWithTheLight) {
  const ColorThresholds dim = color_thresholds({}, {57.5, 120.0, 140.5});
  EXPECT_EQ(dim.medium, 43);
  EXPECT_EQ(dim.bright, 85);
  EXPECT_EQ(dim.cb_neutral, 120);
  EXPECT_EQ(dim.cr_neutral, 141);
  EXPECT_EQ(dim.cb_gray_first, 116);
  EXPECT_EQ(dim.cb_gray_last, 124);
  EXPECT_EQ(dim.cr_gray_first, 136);
  EXPECT_EQ(dim.cr_gray_last, 145);
}

TEST(ColorHistogram, ThresholdsStayInByteRangeUnderExtremeLight) {
  const ColorThresholds bright = color_thresholds({}, {1e9, 1e9, -1e9});
  EXPECT_EQ(bright.bright, 255);
  EXPECT_EQ(bright.cb_neutral, 255);
  EXPECT_EQ(bright.cr_neutral, 0);
}

/// Fractions with the sum 1.
RC_GTEST_PROP(ColorHistogram, BlurringKeepsTheSumAndDoesNotChangeAUniformHistogram, ()) {
  const ColorHistogram histogram = any_histogram();
  const double share = *rc::gen::inRange(0, 26) / 100.0;
  const ColorHistogram result = blurred(histogram, share);
  RC_ASSERT(std::abs(std::accumulate(result.begin(), result.end(), 0.0) - 1.0) < 1e-5);
  ColorHistogram even;
  even.fill(1.0f / 14.0f);
  for (const float value : blurred(even, share)) RC_ASSERT(std::abs(value - 1.0f / 14.0f) < 1e-6f);
}

TEST(ColorHistogram, EveryBinHasFourNeighborsInBothDirections) {
  bool neighbors[kColorBins][kColorBins];
  for (int from = 0; from < kColorBins; ++from) {
    ColorHistogram one{};
    one[static_cast<std::size_t>(from)] = 1.0f;
    const ColorHistogram spread = blurred(one, 0.1);
    int count = 0;
    for (int to = 0; to < kColorBins; ++to) {
      neighbors[from][to] = to != from && spread[static_cast<std::size_t>(to)] > 0.0f;
      count += neighbors[from][to] ? 1 : 0;
    }
    EXPECT_EQ(count, 4) << "bin " << from;
  }
  for (int a = 0; a < kColorBins; ++a) {
    for (int b = 0; b < kColorBins; ++b) EXPECT_EQ(neighbors[a][b], neighbors[b][a]);
  }
}

}  // namespace
}  // namespace reorient

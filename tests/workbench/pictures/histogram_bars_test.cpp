// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/parts/histogram_bars.h"

#include <limits>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/workbench/pictures/pixels.h"
#include "workbench/views/pictures/canvas/ycbcr.h"

namespace reorient::pictures {
namespace {

constexpr Color kGround{207, 212, 218};

using scene::bin_color;
using scene::HistogramBars;
using scene::kHistogramBins;

Picture chart(const HistogramBars& bars, double below) {
  Canvas canvas(280, 100, kGround);
  draw_histogram(canvas, bars, scene::upright_chart({0.0, 0.0}, {280.0, 100.0}, below), 0.5);
  return canvas.finish();
}

TEST(BinColor, LiesInTheRegionOfTheBin) {
  for (int bin = 2; bin < kHistogramBins; ++bin) {
    const Color color = bin_color(bin);
    const double luma = 0.299 * color.red + 0.587 * color.green + 0.114 * color.blue;
    const double cb = 0.564 * (color.blue - luma);
    const double cr = 0.713 * (color.red - luma);
    EXPECT_EQ(int(luma / 85.0), (bin - 2) / 4) << bin;
    EXPECT_EQ((cb > 5.0 ? 1 : 0) + (cr > 5.0 ? 2 : 0), (bin - 2) % 4) << bin;
    EXPECT_GT(std::abs(cb), 5.0) << bin;
    EXPECT_GT(std::abs(cr), 5.0) << bin;
  }
  EXPECT_TRUE(is_similar(bin_color(0), {0, 0, 0}, 24));
  EXPECT_EQ(bin_color(1), (Color{255, 255, 255}));
}

TEST(BinColor, DiffersBetweenAllBins) {
  std::set<std::tuple<int, int, int>> colors;
  for (int bin = 0; bin < kHistogramBins; ++bin) {
    const Color color = bin_color(bin);
    colors.emplace(color.red, color.green, color.blue);
  }
  EXPECT_EQ(colors.size(), 14U);
}

TEST(HistogramBars, RiseWithTheFractionInTheColorOfTheBin) {
  HistogramBars bars;
  bars.share[5] = 0.25F;  // half of the value that fills the height
  const Picture picture = chart(bars, 0.0);
  EXPECT_TRUE(is_similar(picture.at(110, 95), bin_color(5)));
  EXPECT_TRUE(is_similar(picture.at(110, 54), bin_color(5)));
  EXPECT_EQ(picture.at(110, 45), kGround);
  EXPECT_EQ(picture.at(130, 90), kGround);
}

TEST(HistogramBars, GoDownWithTheDeviation) {
  HistogramBars bars;
  bars.share[0] = 0.5F;
  bars.deviation[0] = 0.0625F;  // half of the value that fills the depth
  const Picture picture = chart(bars, 0.4);
  EXPECT_TRUE(is_similar(picture.at(10, 30), bin_color(0)));
  EXPECT_TRUE(is_similar(picture.at(10, 75), bin_color(0)));
  EXPECT_EQ(picture.at(10, 85), kGround);
}

TEST(HistogramBars, EndAtTheTopForLargeFractions) {
  HistogramBars bars;
  bars.share[2] = 1e30F;
  Canvas canvas(280, 100, kGround);
  draw_histogram(canvas, bars, scene::upright_chart({0.0, 40.0}, {280.0, 100.0}), 0.5);
  const Picture picture = canvas.finish();
  EXPECT_TRUE(is_similar(picture.at(50, 45), bin_color(2)));
  EXPECT_EQ(picture.at(50, 36), kGround);
}

TEST(HistogramBars, OmitInvalidFractions) {
  HistogramBars bars;
  bars.share.fill(std::numeric_limits<float>::quiet_NaN());
  bars.share[1] = -0.5F;
  bars.deviation.fill(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(chart(bars, 0.2), chart(HistogramBars{}, 0.2));
}

TEST(Ycbcr, ConvertsPrimaryColorsToThoseOfAScreen) {
  EXPECT_EQ(to_color({0, 128, 128}), (Color{0, 0, 0}));
  EXPECT_EQ(to_color({255, 128, 128}), (Color{255, 255, 255}));
  EXPECT_TRUE(is_similar(to_color({76, 85, 255}), {255, 0, 0}, 3));
  EXPECT_TRUE(is_similar(to_color({150, 44, 21}), {0, 255, 0}, 3));
  EXPECT_TRUE(is_similar(to_color({29, 255, 107}), {0, 0, 255}, 3));
}

TEST(Ycbcr, ReadsPixelsByTheStride) {
  const std::uint8_t bytes[] = {10, 128, 20, 128, 99, 99, 30, 128, 40, 128, 99, 99};
  const Picture picture = to_picture({bytes, 2, 2, 6});
  EXPECT_EQ(picture.bytes, (std::vector<std::uint8_t>{10, 10, 10, 20, 20, 20, 30, 30, 30, 40, 40, 40}));
  EXPECT_EQ(to_picture({}), Picture{});
}

}  // namespace
}  // namespace reorient::pictures

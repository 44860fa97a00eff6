// SPDX-License-Identifier: MIT
#include "perception/room/wall/light_adaptation.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace reorient {
namespace {

/// One frame that shows these tiles in this light.
void observe(LightAdaptation& adaptation, const std::vector<int>& tiles, const Light& light, double elapsed = 0.1) {
  std::vector<TileLight> frame;
  frame.reserve(tiles.size());
  for (const int tile : tiles) frame.push_back({tile, {light.luma * 100, light.cb * 100, light.cr * 100, 100}});
  adaptation.observe(frame, elapsed, {});
}

struct RoomLight : testing::Test {
  RoomLight() { adaptation.restart(8); }
  LightAdaptation adaptation;
};

TEST_F(RoomLight, IsNeutralBeforeAnythingWasSeen) {
  EXPECT_EQ(adaptation.light().luma, 115.0);
  observe(adaptation, {}, {});
  EXPECT_EQ(adaptation.light().luma, 115.0);
  EXPECT_EQ(adaptation.light().cb, 128.0);
}

TEST_F(RoomLight, IsTheMeanOverTheTilesIndependentOfTheirTimeInView) {
  observe(adaptation, {0, 1, 2}, {100, 120, 130});
  for (int i = 0; i < 50; ++i) observe(adaptation, {3}, {140, 124, 134});
  EXPECT_NEAR(adaptation.light().luma, 110.0, 1e-9);
  EXPECT_NEAR(adaptation.light().cb, 121.0, 1e-9);
  EXPECT_NEAR(adaptation.light().cr, 131.0, 1e-9);
}

TEST_F(RoomLight, FollowsATileWithItsTimeConstant) {
  observe(adaptation, {0}, {100, 128, 128});
  for (int i = 0; i < 100; ++i) observe(adaptation, {0}, {200, 128, 128}, 0.01);
  EXPECT_NEAR(adaptation.light().luma, 200.0 - 100.0 * std::exp(-1.0), 0.5);
}

TEST_F(RoomLight, ForgetsTilesThatWereNotSeenForLong) {
  observe(adaptation, {0}, {100, 128, 128});
  for (int i = 0; i < 190; ++i) observe(adaptation, {1}, {140, 128, 128});
  EXPECT_NEAR(adaptation.light().luma, 120.0, 1e-9);
  for (int i = 0; i < 20; ++i) observe(adaptation, {1}, {140, 128, 128});
  EXPECT_NEAR(adaptation.light().luma, 140.0, 1e-9);
}

TEST_F(RoomLight, RestartsAfterATimeWithoutWallInViewOrWithoutFrames) {
  observe(adaptation, {0, 1}, {100, 128, 128});
  for (int i = 0; i < 30; ++i) observe(adaptation, {}, {});
  EXPECT_NEAR(adaptation.light().luma, 100.0, 1e-9) << "the new light is not known yet";
  observe(adaptation, {2}, {50, 128, 128});
  EXPECT_NEAR(adaptation.light().luma, 50.0, 1e-9);
  observe(adaptation, {3}, {70, 128, 128}, 5.0);
  EXPECT_NEAR(adaptation.light().luma, 70.0, 1e-9);
}

TEST(LightAdaptation, IgnoresSaturatedAndBlackPixels) {
  Image image(64, 1);
  for (int x = 0; x < 64; x += 8) {
    const std::uint8_t luma = x == 0 ? 255 : x == 8 ? 5 : 90;
    const std::uint8_t pixel[] = {luma, 100, luma, 150};
    std::copy(std::begin(pixel), std::end(pixel), image.row(0) + 2 * x);
  }
  const LightSums sums = sum_light(image.view(), 0, 0, 64, {});
  EXPECT_EQ(sums.pixels, 6);
  EXPECT_EQ(sums.mean().luma, 90.0);
  EXPECT_EQ(sums.mean().cb, 100.0);
  EXPECT_EQ(sums.mean().cr, 150.0);
}

}  // namespace
}  // namespace reorient

#include "perception/room/light_adaptation.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace reorient {
namespace {

LightSums sums_of(const Light& light, int pixels = 1000) {
  return {light.luma * pixels, light.cb * pixels, light.cr * pixels, pixels};
}

TEST(LightAdaptation, IsNeutralBeforeAnythingWasSeen) {
  const LightAdaptation adaptation;
  EXPECT_EQ(adaptation.light().luma, 115.0);
  EXPECT_EQ(adaptation.light().cb, 128.0);
}

TEST(LightAdaptation, IsATrueMeanAtFirst) {
  LightAdaptation adaptation;
  adaptation.observe(sums_of({100, 120, 130}), 0.1, {});
  EXPECT_NEAR(adaptation.light().luma, 100.0, 1e-9);
  adaptation.observe(sums_of({140, 124, 134}), 0.1, {});
  EXPECT_NEAR(adaptation.light().luma, 120.0, 1e-9);
  EXPECT_NEAR(adaptation.light().cb, 122.0, 1e-9);
  EXPECT_NEAR(adaptation.light().cr, 132.0, 1e-9);
}

TEST(LightAdaptation, ForgetsWithItsTimeConstant) {
  LightAdaptation adaptation;
  for (int i = 0; i < 600; ++i) adaptation.observe(sums_of({100, 128, 128}), 0.1, {});
  for (int i = 0; i < 200; ++i) adaptation.observe(sums_of({200, 128, 128}), 0.1, {});
  EXPECT_NEAR(adaptation.light().luma, 200.0 - 100.0 * std::exp(-1.0), 0.5);
}

TEST(LightAdaptation, StartsAfreshAfterALongTimeWithoutWall) {
  LightAdaptation adaptation;
  for (int i = 0; i < 100; ++i) adaptation.observe(sums_of({100, 128, 128}), 0.1, {});
  for (int i = 0; i < 30; ++i) adaptation.observe({}, 0.1, {});
  EXPECT_NEAR(adaptation.light().luma, 100.0, 1e-9) << "nothing new is known yet";
  adaptation.observe(sums_of({50, 128, 128}), 0.1, {});
  EXPECT_NEAR(adaptation.light().luma, 50.0, 1e-9);
}

TEST(LightAdaptation, LeavesSaturatedAndBlackPixelsOut) {
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

// SPDX-License-Identifier: MIT
#include "robots/simulator/render/sensor.h"

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/angle.h"
#include "tests/robots/simulator/mean_luma.h"

namespace reorient {
namespace {

const RayTable& rays() {
  static const RayTable table(CameraModel::from_fields_of_view(160, 120, from_degrees(56.3), from_degrees(43.7)));
  return table;
}

Frame gray(float light) {
  Frame frame(160, 120, false);
  frame.red.assign(frame.size(), light);
  frame.green.assign(frame.size(), light);
  frame.blue.assign(frame.size(), light);
  return frame;
}

SensorParameters fixed_exposure() {
  SensorParameters parameters;
  parameters.automatic_exposure = false;
  return parameters;
}

double exposed_luma(Sensor& sensor, const Frame& frame, std::uint64_t number = 0) {
  Image image(160, 120);
  sensor.expose(frame, number, 1.0 / 30.0, image);
  return mean_luma(image.view());
}

TEST(Sensor, GivesABrighterImageForMoreLight) {
  double before = -1.0;
  for (const double stops : {-3.0, -1.0, 0.0, 1.0, 2.0}) {
    Sensor sensor(fixed_exposure(), rays(), 1);
    sensor.set_stops(stops);
    const double luma = exposed_luma(sensor, gray(0.15f));
    EXPECT_GT(luma, before + 5.0) << stops << " stops";
    before = luma;
  }
}

TEST(Sensor, AdaptsSlowlyToTheMeanBrightness) {
  Sensor sensor(SensorParameters{}, rays(), 1);
  const double dim = exposed_luma(sensor, gray(0.10f));
  const double jumped = exposed_luma(sensor, gray(0.20f));
  EXPECT_GT(jumped, dim + 15.0) << "the first frame after a change is brighter";
  double settled = jumped;
  for (std::uint64_t i = 0; i < 300; ++i) settled = exposed_luma(sensor, gray(0.20f), i);
  EXPECT_NEAR(settled, dim, 2.0);
}

TEST(Sensor, DoesNotAdaptToStopsThatAreSet) {
  Sensor sensor(SensorParameters{}, rays(), 1);
  const double before = exposed_luma(sensor, gray(0.10f));
  sensor.set_stops(-1.0);
  double after = 0.0;
  for (std::uint64_t i = 0; i < 300; ++i) after = exposed_luma(sensor, gray(0.10f), i);
  EXPECT_LT(after, before - 15.0);
}

TEST(Sensor, LosesLightInTheCorners) {
  SensorParameters parameters = fixed_exposure();
  parameters.luma_noise = 0.0;
  Sensor sensor(parameters, rays(), 1);
  Image image(160, 120);
  sensor.expose(gray(0.2f), 0, 0.03, image);
  EXPECT_LT(image.view().luma(1, 1), 0.8 * image.view().luma(80, 60));
}

TEST(Sensor, GivesGrayForGrayWithoutAColorCast) {
  SensorParameters parameters = fixed_exposure();
  parameters.warmth = parameters.tint = parameters.chroma_noise = 0.0;
  Sensor sensor(parameters, rays(), 1);
  Image image(160, 120);
  sensor.expose(gray(0.2f), 0, 0.03, image);
  EXPECT_EQ(image.view().at(80, 60).cb, 128);
  EXPECT_EQ(image.view().at(80, 60).cr, 128);
}

TEST(Sensor, AddsTheNoiseThatItsParametersSet) {
  SensorParameters parameters = fixed_exposure();
  parameters.vignetting = 0.0;
  parameters.luma_noise = 5.0;
  Sensor sensor(parameters, rays(), 1);
  Image image(160, 120);
  sensor.expose(gray(0.2f), 0, 0.03, image);
  const double mean = mean_luma(image.view());
  double square = 0.0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) square += std::pow(image.view().luma(x, y) - mean, 2);
  }
  EXPECT_NEAR(std::sqrt(square / (160 * 120)), 5.0, 0.3);
}

TEST(Sensor, RepeatsItsNoiseOnlyForTheSameFrameNumber) {
  Sensor one(fixed_exposure(), rays(), 9);
  Sensor two(fixed_exposure(), rays(), 9);
  Image first(160, 120);
  Image again(160, 120);
  Image next(160, 120);
  one.expose(gray(0.2f), 4, 0.03, first);
  two.expose(gray(0.2f), 4, 0.03, again);
  two.expose(gray(0.2f), 5, 0.03, next);
  EXPECT_EQ(first.bytes(), again.bytes());
  EXPECT_NE(first.bytes(), next.bytes());
}

}  // namespace
}  // namespace reorient

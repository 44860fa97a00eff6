// SPDX-License-Identifier: MIT
#include "robots/simulator/ball/ball_sensor.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/angle.h"
#include "geometry/head.h"
#include "robots/robot_body.h"

namespace reorient {
namespace {

const CameraModel& sensor_camera() {
  static const CameraModel camera = camera_model(CameraOptics(), 320, 240);
  return camera;
}

/// The ball `ahead` and `left` of a robot that stands at the center of the field.
BallView view_of(double ahead, double left, std::span<const Occluder> occluders = {}) {
  static const RobotBody body;
  static const Isometry3 upper =
      robot_from_camera(body.dimensions, {0.0, 0.1}, {}, body.dimensions.torso_height, HeadCamera::upper);
  return {{ahead, left, 0.05}, Pose2(), {&upper, 1}, sensor_camera(), occluders};
}

struct Spread {
  double mean_distance = 0.0, distance = 0.0, bearing = 0.0;  // m, m, rad
  int seen = 0;
};

Spread spread_at(double distance, const BallSensorParameters& parameters) {
  BallSensor sensor(parameters, 7);
  Spread spread;
  double distances = 0.0, squares = 0.0, bearings = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const auto measured = sensor.measure(view_of(distance, 0.0));
    if (!measured) continue;
    ++spread.seen;
    distances += measured->norm();
    squares += measured->squaredNorm();
    bearings += std::pow(std::atan2(measured->y(), measured->x()), 2.0);
  }
  spread.mean_distance = distances / spread.seen;
  spread.distance = std::sqrt(squares / spread.seen - spread.mean_distance * spread.mean_distance);
  spread.bearing = std::sqrt(bearings / spread.seen);
  return spread;
}

TEST(BallSensor, MeasuresTheDistanceWithAnErrorThatGrowsWithItsSquare) {
  const BallSensorParameters parameters;
  for (const double distance : {1.0, 2.0, 3.0}) {
    const Spread spread = spread_at(distance, parameters);
    const double height = view_of(distance, 0.0).field_from_cameras[0].translation().z() - 0.05;
    const double expected = parameters.elevation_noise * (height + distance * distance / height);
    EXPECT_NEAR(spread.distance, expected, 0.15 * expected) << distance;
    EXPECT_NEAR(spread.mean_distance, distance, 0.05 * distance) << distance;
    EXPECT_NEAR(spread.bearing, parameters.bearing_noise, 0.15 * parameters.bearing_noise) << distance;
  }
}

TEST(BallSensor, MissesTheStatedFractionOfTheImages) {
  BallSensorParameters parameters;
  parameters.missed = 0.3;
  EXPECT_NEAR(spread_at(2.0, parameters).seen, 1400, 60);
  parameters.missed = 1.0;
  EXPECT_FALSE(BallSensor(parameters, 1).measure(view_of(2.0, 0.0)));
}

TEST(BallSensor, SeesOnlyWhatIsInTheImageAndWithinItsRange) {
  BallSensorParameters parameters;
  parameters.missed = 0.0;
  BallSensor sensor(parameters, 1);
  EXPECT_TRUE(sensor.measure(view_of(2.0, 0.5)));
  EXPECT_FALSE(sensor.measure(view_of(2.0, 2.0))) << "beside the image";
  EXPECT_FALSE(sensor.measure(view_of(-2.0, 0.0))) << "behind the robot";
  EXPECT_FALSE(sensor.measure(view_of(0.2, 0.0))) << "below the image";
  EXPECT_FALSE(sensor.measure(view_of(5.2, 0.0))) << "out of range";
}

TEST(BallSensor, DoesNotSeeABallBehindARobot) {
  BallSensorParameters parameters;
  parameters.missed = 0.0;
  BallSensor sensor(parameters, 1);
  const std::vector<Occluder> between{{{1.5, 0.0}}}, beside{{{1.5, 0.3}}}, behind{{{2.5, 0.0}}};
  EXPECT_FALSE(sensor.measure(view_of(2.0, 0.0, between)));
  EXPECT_TRUE(sensor.measure(view_of(2.0, 0.0, beside)));
  EXPECT_TRUE(sensor.measure(view_of(2.0, 0.0, behind)));
  const std::vector<Occluder> lying{{{0.8, 0.0}, 0.12, 0.15}};
  EXPECT_TRUE(sensor.measure(view_of(2.0, 0.0, lying))) << "over the robot that lies on the ground";
}

TEST(BallSensor, NeverMeasuresAnInfiniteDistance) {
  BallSensorParameters parameters;
  parameters.missed = 0.0;
  parameters.elevation_noise = 0.2;
  BallSensor sensor(parameters, 5);
  for (int i = 0; i < 2000; ++i) {
    const auto measured = sensor.measure(view_of(4.5, 0.0));
    ASSERT_TRUE(measured);
    EXPECT_LE(measured->norm(), 1.5 * parameters.range + 0.2);
  }
}

}  // namespace
}  // namespace reorient

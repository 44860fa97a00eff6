// SPDX-License-Identifier: MIT
#include "engine/world/posture.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/bytes.h"
#include "robots/simulator/body/body.h"

namespace reorient {
namespace {

constexpr double kBodyStep = 0.01;
constexpr double kStanding = 5.3;
const Eigen::Vector2d kBounds(8.0, 6.0);

BodySample felt(double load, double roll = 0.0, double pitch = 0.0) {
  BodySample sample;
  sample.foot_load = load;
  sample.torso = {roll, pitch};
  return sample;
}

class Standing : public ::testing::Test {
 protected:
  void feel(BodySample sample, double seconds = kBodyStep) {
    for (double t = 0.0; t < seconds - 1e-9; t += kBodyStep) {
      sample.time = time += kBodyStep;
      posture.update(sample, standing_load, hints, parameters);
    }
  }

  double time = 0.0;
  std::optional<double> standing_load = 5.3;  // kg
  PostureEstimator::Hints hints;
  PostureParameters parameters;
  PostureEstimator posture;
};

TEST_F(Standing, IsUprightAtFirstAndWhileItsFeetAreLoaded) {
  EXPECT_EQ(posture.posture(), Posture::upright);
  feel(felt(kStanding), 2.0);
  EXPECT_EQ(posture.posture(), Posture::upright);
}

TEST_F(Standing, LiesAtOnceIfItTiltsBeyondTheAngleInAnyDirection) {
  for (const BodySample& down :
       {felt(kStanding, 0.81), felt(kStanding, -0.81), felt(kStanding, 0.0, 0.81), felt(kStanding, 0.0, -0.81)}) {
    posture = {};
    feel(felt(kStanding), 1.0);
    feel(down);
    EXPECT_EQ(posture.posture(), Posture::lying);
    EXPECT_EQ(posture.before(), Posture::upright);
    EXPECT_NEAR(posture.since(), time, 1e-9);
  }
}

TEST_F(Standing, FallsIfItTipsFastOrTiltsFar) {
  BodySample tipping = felt(kStanding, 0.0, 0.2);
  tipping.angular_velocity.y() = 2.0;
  feel(tipping, 0.1);
  EXPECT_EQ(posture.posture(), Posture::falling);

  posture = {};
  feel(felt(kStanding, 0.0, 0.5));
  EXPECT_EQ(posture.posture(), Posture::falling);
}

TEST_F(Standing, DoesNotFallByAPushOrAShortTilt) {
  BodySample knock = felt(kStanding, 0.0, 0.12);
  knock.angular_velocity.y() = 3.0;
  feel(knock);
  EXPECT_EQ(posture.posture(), Posture::upright);
  feel(felt(kStanding, 0.0, 0.4), 1.0);
  EXPECT_EQ(posture.posture(), Posture::upright);
}

TEST_F(Standing, IsUprightAgainAfterItRecoveredItsBalance) {
  feel(felt(kStanding, 0.0, 0.5), 0.1);
  ASSERT_EQ(posture.posture(), Posture::falling);
  feel(felt(kStanding), 0.2);
  EXPECT_EQ(posture.posture(), Posture::falling);
  feel(felt(kStanding), 0.2);
  EXPECT_EQ(posture.posture(), Posture::upright);
}

TEST_F(Standing, IsLiftedAfterItsFeetAreUnloadedForLong) {
  feel(felt(0.2), 0.5);
  EXPECT_EQ(posture.posture(), Posture::upright) << "a falling robot also has unloaded feet";
  feel(felt(0.2), 0.2);
  EXPECT_EQ(posture.posture(), Posture::lifted);
}

TEST_F(Standing, IsLiftedSoonerIfItRises) {
  feel(felt(kStanding), 1.0);
  BodySample up = felt(0.2);
  up.acceleration.z() += 3.0;
  feel(up, 0.3);
  EXPECT_EQ(posture.posture(), Posture::lifted);
}

TEST_F(Standing, DoesNotCountStepsAsALift) {
  for (int step = 0; step < 50; ++step) {
    feel(felt(0.2), 0.2);
    feel(felt(kStanding), 0.05);
    ASSERT_EQ(posture.posture(), Posture::upright);
  }
}

TEST_F(Standing, IsUprightOnceItsFeetAreLoaded) {
  feel(felt(0.2), 1.0);
  ASSERT_EQ(posture.posture(), Posture::lifted);
  feel(felt(5.0), 0.1);
  EXPECT_EQ(posture.posture(), Posture::lifted);
  feel(felt(5.0), 0.2);
  EXPECT_EQ(posture.posture(), Posture::upright);
}

TEST_F(Standing, LiesAfterALiftOnlyOnceItIsAtRest) {
  feel(felt(0.0), 1.0);
  ASSERT_EQ(posture.posture(), Posture::lifted);
  BodySample turned = felt(0.0, 1.5);
  turned.angular_velocity.x() = 0.5;
  feel(turned, 2.0);
  EXPECT_EQ(posture.posture(), Posture::lifted) << "a lifted robot can have any attitude";
  turned.angular_velocity.setZero();
  feel(turned, 0.6);
  EXPECT_EQ(posture.posture(), Posture::lying);
}

TEST_F(Standing, GetsUpWithUnloadedFeetWithoutCountingAsLifted) {
  feel(felt(0.5, 0.0, 1.5), 2.0);
  ASSERT_EQ(posture.posture(), Posture::lying);
  hints.gets_up = true;
  feel(felt(0.5, 0.0, 0.6), 1.0);
  EXPECT_EQ(posture.posture(), Posture::getting_up);
  feel(felt(0.5), 2.0);
  EXPECT_EQ(posture.posture(), Posture::getting_up) << "its feet are not loaded yet";
  feel(felt(kStanding), 0.4);
  EXPECT_EQ(posture.posture(), Posture::upright);
}

TEST_F(Standing, CountsAsLiftedWithoutARequestToGetUp) {
  feel(felt(0.5, 0.0, 1.5), 2.0);
  feel(felt(0.0, 0.0, 0.1), 1.0);
  EXPECT_EQ(posture.posture(), Posture::lifted);
}

TEST_F(Standing, UsesThePostureThatTheRobotReports) {
  hints.reported = ReportedPosture::falling;
  feel(felt(kStanding));
  EXPECT_EQ(posture.posture(), Posture::falling);
  hints.reported = ReportedPosture::fallen;
  feel(felt(kStanding));
  EXPECT_EQ(posture.posture(), Posture::lying);
  hints.reported = ReportedPosture::getting_up;
  feel(felt(kStanding));
  EXPECT_EQ(posture.posture(), Posture::getting_up);
  hints.reported = ReportedPosture::upright;
  feel(felt(kStanding), 0.5);
  EXPECT_EQ(posture.posture(), Posture::upright);
  feel(felt(kStanding, 0.0, 0.9), 0.5);
  EXPECT_EQ(posture.posture(), Posture::upright) << "the robot reports that it is upright";
}

TEST_F(Standing, WithoutFootSensorsIsLiftedByRisingAndPlacedByStandingStill) {
  standing_load.reset();
  feel(felt(0.0), 2.0);
  ASSERT_EQ(posture.posture(), Posture::upright) << "without foot sensors a load of 0 has no meaning";
  BodySample up = felt(0.0);
  up.acceleration.z() += 3.0;
  feel(up, 0.4);
  ASSERT_EQ(posture.posture(), Posture::lifted);
  BodySample swaying = felt(0.0, 0.05);
  swaying.angular_velocity.x() = 0.4;
  feel(swaying, 5.0);
  EXPECT_EQ(posture.posture(), Posture::lifted);
  feel(felt(0.0), 0.6);
  EXPECT_EQ(posture.posture(), Posture::upright);
}

TEST_F(Standing, IgnoresSamplesThatAreNotFiniteOrOutOfOrder) {
  feel(felt(kStanding), 1.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BodySample bad = felt(kStanding, nan);
  bad.time = time + 0.1;
  posture.update(bad, standing_load, hints, parameters);
  bad = felt(0.0, 1.5);
  bad.acceleration.x() = std::numeric_limits<double>::infinity();
  bad.time = time + 0.1;
  posture.update(bad, standing_load, hints, parameters);
  BodySample late = felt(0.0, 1.5);
  late.time = time - 0.5;
  posture.update(late, standing_load, hints, parameters);
  EXPECT_EQ(posture.posture(), Posture::upright);
}

TEST_F(Standing, ContinuesWhenTheRobotsClockRestarts) {
  time = 1e6;
  feel(felt(kStanding), 1.0);
  time = 0.0;
  feel(felt(kStanding, 0.0, 1.5), 0.5);
  EXPECT_EQ(posture.posture(), Posture::lying);
}

RC_GTEST_PROP(PostureProperty, StaysFiniteAndContinuesWithItsBytes, ()) {
  PostureEstimator one;
  const PostureParameters parameters;
  const std::optional<double> standing_load = *rc::gen::arbitrary<bool>() ? std::optional(5.3) : std::nullopt;
  double time = 0.0;
  const auto draw = [](int most) { return 0.01 * *rc::gen::inRange(-most, most + 1); };
  const auto next = [&] {
    BodySample sample = felt(std::abs(draw(600)), draw(300), draw(300));
    sample.time = time += std::abs(draw(40));
    sample.angular_velocity = {draw(1000), draw(1000), draw(1000)};
    sample.acceleration = {draw(5000), draw(5000), draw(5000)};
    return sample;
  };
  for (int i = 0; i < 20; ++i) one.update(next(), standing_load, {}, parameters);
  std::vector<std::byte> bytes;
  ByteWriter writer(bytes);
  writer(one);
  PostureEstimator other;
  ByteReader reader(bytes);
  reader(other);
  for (int i = 0; i < 20; ++i) {
    const BodySample sample = next();
    one.update(sample, standing_load, {}, parameters);
    other.update(sample, standing_load, {}, parameters);
    RC_ASSERT(one.posture() == other.posture());
    RC_ASSERT(one.since() == other.since());
  }
}

/// A body of the simulator with 100 samples per second.
class SimulatedBody : public ::testing::TestWithParam<bool> {
 protected:
  SimulatedBody() {
    BodyParameters of_body;
    of_body.foot_sensors = GetParam();
    if (!of_body.foot_sensors) standing_load.reset();
    body.emplace(of_body, RobotBody{}, Pose2(), 3);
  }

  void run(double seconds) {
    for (double t = 0.0; t < seconds; t += kBodyStep) {
      body->advance(kBodyStep, request, {}, kBounds);
      time += kBodyStep;
      const Posture before = posture.posture();
      posture.update(body->sample(time), standing_load, {ReportedPosture::unknown, request.get_up}, parameters);
      if (posture.posture() != before) seen.push_back(posture.posture());
    }
  }

  double time = 0.0;
  std::optional<double> standing_load = 5.3;  // kg
  std::optional<Body> body;
  Request request;
  PostureParameters parameters;
  PostureEstimator posture;
  std::vector<Posture> seen;
};

TEST_P(SimulatedBody, IsUprightWhileItWalks) {
  for (int i = 0; i < 10; ++i) {
    request.walk = {i % 2 == 0 ? 0.3 : -0.2, 0.1, i % 3 == 0 ? 0.8 : 0.0};
    run(3.0);
  }
  EXPECT_TRUE(seen.empty());
}

TEST_P(SimulatedBody, IsLiftedAndPlaced) {
  run(2.0);
  body->pick_up();
  run(3.0);
  EXPECT_EQ(posture.posture(), Posture::lifted);
  body->put_down(Pose2(1.0, 1.0, 1.0));
  run(3.0);
  EXPECT_EQ(seen, (std::vector<Posture>{Posture::lifted, Posture::upright}));
}

TEST_P(SimulatedBody, FallsLiesGetsUpAndStands) {
  run(2.0);
  body->push_over();
  run(3.0);
  request.get_up = true;
  run(8.0);
  EXPECT_EQ(seen, (std::vector<Posture>{Posture::falling, Posture::lying, Posture::getting_up, Posture::upright}));
}

INSTANTIATE_TEST_SUITE_P(Robots, SimulatedBody, ::testing::Bool(),
                         [](const auto& test) { return test.param ? "WithFootSensors" : "InertialUnitAlone"; });

}  // namespace
}  // namespace reorient

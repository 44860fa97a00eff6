// SPDX-License-Identifier: MIT
// What the accelerometer says of the torso's attitude.
#include "localization/tracking/gravity_bias.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "geometry/gravity.h"
#include "geometry/random.h"
#include "localization/tracking/pose_tracker.h"

namespace reorient {
namespace {

constexpr double kPeriod = 0.03;  // s

/// A robot that walks, and whose inertial unit measures `bias` less than is true. Keeps what it is told of that.
struct Walk {
  void walk(double seconds, const TiltBias& bias) {
    for (const double end = time + seconds; time < end; time += kPeriod) {
      const TorsoAttitude truth{0.03 * std::sin(7.0 * time), 0.1 + 0.02 * std::sin(11.0 * time)};
      const Eigen::Vector3d shock(random.normal(), random.normal(), random.normal());
      const auto bias_now =
          gravity.feel(kGravity * up_in_torso(truth) + shock, {truth.roll - bias.roll, truth.pitch - bias.pitch}, time);
      if (!bias_now) continue;
      told = *bias_now;
      ++times;
    }
  }
  GravityBias gravity;
  Random random{3};
  double time = 0.0;
  TiltBias told;
  int times = 0;
};

TEST(GravityBias, IsToldOnceAfterSomeSecondsOfWalking) {
  Walk walk;
  const TiltBias bias{-0.03, 0.087};
  walk.walk(2.5, bias);
  EXPECT_EQ(walk.times, 0);
  walk.walk(60.0, bias);
  EXPECT_EQ(walk.times, 1);
  EXPECT_NEAR(walk.told.roll, bias.roll, 0.03);
  EXPECT_NEAR(walk.told.pitch, bias.pitch, 0.03);
}

TEST(GravityBias, CountsFromAnewAfterTheRobotHasLostItsFeet) {
  Walk walk;
  walk.walk(2.5, {0.3, 0.3});
  walk.gravity.interrupt();
  walk.walk(2.5, {});
  EXPECT_EQ(walk.times, 0);
  walk.walk(2.0, {});
  EXPECT_EQ(walk.times, 1);
  EXPECT_NEAR(walk.told.pitch, 0.0, 0.03) << "what was felt before does not count";
}

TEST(GravityBias, IsNothingWithoutAnAccelerometerOrWithNonsense) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  GravityBias gravity;
  double time = 0.0;
  for (const Eigen::Vector3d& said :
       {Eigen::Vector3d(0.0, 0.0, 9.81), Eigen::Vector3d(nan, 0.0, 9.81), Eigen::Vector3d(infinite, 0.0, 0.0),
        Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(30.0, 1.0, 9.81)}) {
    for (int i = 0; i < 1000; ++i) EXPECT_FALSE(gravity.feel(said, {0.0, 0.1}, time += kPeriod));
  }
  for (int i = 0; i < 1000; ++i) {
    EXPECT_FALSE(gravity.feel({0.5, 0.0, 9.8}, {nan, 0.0}, time += kPeriod));
    EXPECT_FALSE(gravity.feel({0.5, 0.0, 9.8}, {2.0, 0.0}, time += kPeriod)) << "it lies";
    EXPECT_FALSE(gravity.feel({0.5, 0.0, 9.8}, {0.0, 0.0}, nan));
  }
}

TEST(GravityBias, IsWeighedAgainstWhatIsUsualAndGivesWayToNothing) {
  const TiltBias five_degrees{0.0, from_degrees(-5.0)};
  PoseTracker tracker({}, FieldDimensions());
  const double before = tracker.bias().deviation;
  tracker.take_gravity(five_degrees);
  // 3 degrees are usual, gravity is known to 1.5: four fifths of what it says.
  EXPECT_NEAR(to_degrees(tracker.bias().torso.pitch), -4.0, 1e-9);
  EXPECT_LT(tracker.bias().deviation, before);
  tracker.let_go();
  EXPECT_NEAR(to_degrees(tracker.bias().torso.pitch), -4.0, 1e-9) << "a lost place does not change gravity";

  PoseTrackerParameters deaf;
  deaf.gravity_deviation = 0.0;
  PoseTracker other(deaf, FieldDimensions());
  other.take_gravity(five_degrees);
  EXPECT_EQ(other.bias().torso.pitch, 0.0);
}

}  // namespace
}  // namespace reorient

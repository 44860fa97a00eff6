// SPDX-License-Identifier: MIT
// The error of the torso's attitude, estimated with the accelerometer.
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

/// A walking robot whose inertial unit measures angles that are too small by `bias`. Stores the estimate of this bias.
struct Walk {
  void walk(double seconds, const TiltBias& bias) {
    for (const double end = time + seconds; time < end; time += kPeriod) {
      const TorsoAttitude truth{0.03 * std::sin(7.0 * time), 0.1 + 0.02 * std::sin(11.0 * time)};
      const Eigen::Vector3d shock(random.normal(), random.normal(), random.normal());
      const auto bias_now = gravity.add_sample(kGravity * up_in_torso(truth) + shock,
                                               {truth.roll - bias.roll, truth.pitch - bias.pitch}, time);
      if (!bias_now) continue;
      estimate = *bias_now;
      ++times;
    }
  }
  GravityBias gravity;
  Random random{3};
  double time = 0.0;
  TiltBias estimate;
  int times = 0;
};

TEST(GravityBias, IsReportedOnceAfterSomeSecondsOfWalking) {
  Walk walk;
  const TiltBias bias{-0.03, 0.087};
  walk.walk(2.5, bias);
  EXPECT_EQ(walk.times, 0);
  walk.walk(60.0, bias);
  EXPECT_EQ(walk.times, 1);
  EXPECT_NEAR(walk.estimate.roll, bias.roll, 0.03);
  EXPECT_NEAR(walk.estimate.pitch, bias.pitch, 0.03);
}

TEST(GravityBias, StartsAgainAfterTheRobotWasNotOnItsFeet) {
  Walk walk;
  walk.walk(2.5, {0.3, 0.3});
  walk.gravity.interrupt();
  walk.walk(2.5, {});
  EXPECT_EQ(walk.times, 0);
  walk.walk(2.0, {});
  EXPECT_EQ(walk.times, 1);
  EXPECT_NEAR(walk.estimate.pitch, 0.0, 0.03) << "earlier samples do not count";
}

TEST(GravityBias, IsNotReportedWithoutAnAccelerometerOrFromInvalidValues) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  GravityBias gravity;
  double time = 0.0;
  for (const Eigen::Vector3d& acceleration :
       {Eigen::Vector3d(0.0, 0.0, 9.81), Eigen::Vector3d(nan, 0.0, 9.81), Eigen::Vector3d(infinite, 0.0, 0.0),
        Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(30.0, 1.0, 9.81)}) {
    for (int i = 0; i < 1000; ++i) EXPECT_FALSE(gravity.add_sample(acceleration, {0.0, 0.1}, time += kPeriod));
  }
  for (int i = 0; i < 1000; ++i) {
    EXPECT_FALSE(gravity.add_sample({0.5, 0.0, 9.8}, {nan, 0.0}, time += kPeriod));
    EXPECT_FALSE(gravity.add_sample({0.5, 0.0, 9.8}, {2.0, 0.0}, time += kPeriod)) << "the robot lies";
    EXPECT_FALSE(gravity.add_sample({0.5, 0.0, 9.8}, {0.0, 0.0}, nan));
  }
}

TEST(GravityBias, IsWeighedAgainstTheUsualBiasAndRemainsWhenThePoseIsLost) {
  const TiltBias five_degrees{0.0, from_degrees(-5.0)};
  PoseTracker tracker({}, FieldDimensions());
  const double before = tracker.bias().deviation;
  tracker.take_gravity(five_degrees);
  // Deviations of 3 degrees (usual bias) and 1.5 degrees (gravity): four fifths of the measured bias.
  EXPECT_NEAR(to_degrees(tracker.bias().torso.pitch), -4.0, 1e-9);
  EXPECT_LT(tracker.bias().deviation, before);
  tracker.detach();
  EXPECT_NEAR(to_degrees(tracker.bias().torso.pitch), -4.0, 1e-9) << "gravity does not depend on the pose";

  PoseTrackerParameters without_gravity;
  without_gravity.gravity_deviation = 0.0;
  PoseTracker other(without_gravity, FieldDimensions());
  other.take_gravity(five_degrees);
  EXPECT_EQ(other.bias().torso.pitch, 0.0);
}

}  // namespace
}  // namespace reorient

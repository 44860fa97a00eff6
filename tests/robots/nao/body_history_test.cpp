// SPDX-License-Identifier: MIT
#include "robots/nao/body_history.h"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "geometry/angle.h"
#include "tests/robots/nao/twin/twin_body.h"

namespace reorient::nao {
namespace {

class BodyHistoryTest : public testing::Test {
 protected:
  void measure(double seconds, float turning = 0.0f, float bias = 0.0f) {
    for (const double end = time_ + seconds; time_ < end; time_ += 0.012) {
      Measurement measurement = body_.measurement();
      measurement.time = time_;
      measurement.position[kHeadYaw] = static_cast<float>(time_);
      measurement.gyroscope[2] = turning + bias;
      measurement.is_walked = walks_ ? 1 : 0;
      measurement.walked = walked_;
      walked_[0] += 0.0024f;  // 0.2 m/s
      history_.add(measurement);
    }
  }
  TwinBody body_;
  BodyHistory history_;
  bool walks_ = false;
  std::array<float, 3> walked_{};
  double time_ = 0.012;
};

TEST_F(BodyHistoryTest, IsInterpolatedBetweenTwoMeasurements) {
  measure(0.5);
  const auto moment = history_.at(0.3456);
  ASSERT_TRUE(moment);
  EXPECT_NEAR(moment->body.head.yaw, 0.3456, 1e-6);
  EXPECT_NEAR(moment->body.time, 0.3456, 1e-12);
}

TEST_F(BodyHistoryTest, ReturnsNothingForTimesTooLongAgoOrInTheFuture) {
  EXPECT_FALSE(history_.at(0.0));
  measure(2.0);
  EXPECT_FALSE(history_.at(0.5));
  EXPECT_TRUE(history_.at(time_ + 0.05));
  EXPECT_FALSE(history_.at(time_ + 0.2));
}

TEST_F(BodyHistoryTest, ReturnsNothingWithinAGap) {
  measure(0.2);
  time_ += 0.3;
  measure(0.2);
  EXPECT_FALSE(history_.at(0.35));
  EXPECT_TRUE(history_.at(0.6));
}

TEST_F(BodyHistoryTest, TranslatesWithTheWalkAndRotatesWithTheInertialUnit) {
  walks_ = true;
  measure(1.0);
  EXPECT_NEAR(history_.newest()->odometry.position.x(), 0.2, 0.01);
  measure(1.0, static_cast<float>(kPi / 2.0));
  const Pose2 before = history_.newest()->odometry;
  EXPECT_NEAR(before.rotation, kPi / 2.0, 0.03);
  measure(1.0);
  EXPECT_NEAR((history_.newest()->odometry.position - before.position - Eigen::Vector2d(0.0, 0.2)).norm(), 0.0, 0.01);
  const auto moment = history_.at(time_ - 0.1);
  ASSERT_TRUE(moment);
  EXPECT_LT(moment->odometry.position.y(), history_.newest()->odometry.position.y());
}

TEST_F(BodyHistoryTest, DoesNotJumpIfAWalkRestartsOrReportsInvalidValues) {
  walks_ = true;
  measure(1.0);
  walked_ = {5.0f, -3.0f, 2.0f};
  measure(0.1);
  walked_[1] = std::numeric_limits<float>::quiet_NaN();
  measure(0.1);
  walked_ = {};
  measure(0.1);
  EXPECT_NEAR(history_.newest()->odometry.position.norm(), 0.2, 0.1);
}

TEST_F(BodyHistoryTest, MeasuresGravityUpwardsAndTheWeightOnTheFeet) {
  measure(0.1);
  const auto moment = history_.newest();
  ASSERT_TRUE(moment);
  EXPECT_NEAR(moment->body.acceleration.z(), 9.81, 1e-3);
  EXPECT_NEAR(moment->body.foot_load, 5.3, 1e-3);
}

TEST_F(BodyHistoryTest, IntegratesTheRotationWithoutTheGyroscopesBias) {
  measure(20.0, 0.0f, 0.02f);
  const double before = history_.newest()->odometry.rotation;
  measure(3.0, 0.5f, 0.02f);
  const double turned = angle_difference(history_.newest()->odometry.rotation, before);
  EXPECT_NEAR(turned, 1.5, 0.02);
  measure(60.0, 0.0f, 0.02f);
  EXPECT_NEAR(angle_difference(history_.newest()->odometry.rotation, before), 1.5, 0.05);
}

TEST_F(BodyHistoryTest, RotationIsAboutTheVerticalAlsoIfTheRobotLeans) {
  body_.tilt(0.0f, 0.5f);
  Measurement measurement = body_.measurement();
  // Turning to the left at 1 rad/s about the vertical, as measured in a torso that leans forward.
  measurement.gyroscope = {-std::sin(0.5f), 0.0f, std::cos(0.5f)};
  for (int i = 1; i <= 100; ++i) {
    measurement.time = 0.01 * i;
    history_.add(measurement);
  }
  EXPECT_NEAR(history_.newest()->odometry.rotation, 0.99, 1e-3);
}

}  // namespace
}  // namespace reorient::nao

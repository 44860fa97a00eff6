// SPDX-License-Identifier: MIT
#include "robots/simulator/body/body.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/gravity.h"

namespace reorient {
namespace {

constexpr double kStep = 1.0 / 30.0;
const Eigen::Vector2d kBounds(8.0, 6.0);

Body body_at(const Pose2& pose, std::uint64_t seed = 1, const BodyParameters& parameters = {}) {
  return {parameters, RobotBody{}, pose, seed};
}

void run(Body& body, const Request& request, double seconds, const std::vector<Barrier>& barriers = {}) {
  for (double time = 0.0; time < seconds - 1e-9; time += kStep) body.advance(kStep, request, barriers, kBounds);
}

Request walking(double forward, double left, double turn) {
  Request request;
  request.walk = {forward, left, turn};
  return request;
}

BodySample felt(Body& body) { return body.sample(1.0); }

TEST(Body, WalksNoFasterThanItsLimits) {
  Body body = body_at({});
  run(body, walking(9.0, 0.0, 0.0), 2.0);
  const double before = body.pose().position.x();
  run(body, walking(9.0, 0.0, 0.0), 2.0);
  EXPECT_NEAR(body.pose().position.x() - before, 0.5, 0.01);
  Body turning = body_at({});
  run(turning, walking(0.0, 0.0, -9.0), 1.0);
  EXPECT_NEAR(turning.velocity().turn, -0.8, 1e-9);
}

TEST(Body, NeedsTimeToReachItsSpeed) {
  Body body = body_at({});
  run(body, walking(0.25, 0.0, 0.0), 0.2);
  EXPECT_NEAR(body.velocity().forward, 0.07, 0.02);
  run(body, walking(0.25, 0.0, 0.0), 1.0);
  EXPECT_NEAR(body.velocity().forward, 0.25, 1e-9);
}

TEST(Body, IgnoresRequestsThatAreNotNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  Body body = body_at({});
  Request request = walking(nan, infinite, -nan);
  request.head = HeadRequest{{nan, infinite}, nan};
  run(body, request, 1.0);
  EXPECT_TRUE(body.pose().position.isZero());
  EXPECT_TRUE(std::isfinite(body.head().yaw) && std::isfinite(body.head().pitch));
}

TEST(Body, TurnsItsHeadAtTheRequestedSpeedWithinItsLimit) {
  Body slow = body_at({});
  Request request;
  request.head = HeadRequest{{1.5, 0.0}, 1.0};
  run(slow, request, 0.5);
  EXPECT_NEAR(slow.head().yaw, 0.5, 0.05);
  Body fast = body_at({});
  request.head->speed = 1000.0;
  fast.advance(kStep, request, {}, kBounds);
  EXPECT_NEAR(fast.head().yaw, 8.0 * kStep, 1e-9);
}

TEST(Body, DoesNotMoveItsHeadWithoutARequest) {
  Body body = body_at({});
  Request request;
  request.head = HeadRequest{{1.0, 0.1}, 2.0};
  run(body, request, 0.2);
  const HeadAngles there = body.head();
  run(body, Request{}, 1.0);
  EXPECT_EQ(body.head().yaw, there.yaw);
  EXPECT_EQ(body.head().pitch, there.pitch);
}

RC_GTEST_PROP(Body, KeepsItsHeadWithinReach, ()) {
  Body body = body_at({});
  for (int i = 0; i < 5; ++i) {
    Request request;
    request.head = HeadRequest{{*rc::gen::inRange(-400, 400) * 1e-2, *rc::gen::inRange(-200, 200) * 1e-2}, 20.0};
    for (int frame = 0; frame < 12; ++frame) {
      body.advance(kStep, request, {}, kBounds);
      const HeadAngles reached = NeckReach().clamp(body.head());
      RC_ASSERT(reached.yaw == body.head().yaw);
      RC_ASSERT(reached.pitch == body.head().pitch);
    }
  }
}

TEST(Body, HasOdometryThatIsGoodButNotPerfect) {
  double worst = 0.0;
  double mean = 0.0;
  constexpr int kRobots = 40;
  for (int seed = 0; seed < kRobots; ++seed) {
    Body body = body_at(Pose2(-1.0, 0.0, 0.4), static_cast<std::uint64_t>(seed));
    const Pose2 start = body.pose();
    run(body, walking(0.2, 0.0, 0.15), 15.0);
    const Pose2 moved = start.inverse() * body.pose();
    const Pose2 believed = body.odometry();
    const double error = (moved.position - believed.position).norm();
    worst = std::max(worst, error);
    mean += error / kRobots;
  }
  EXPECT_GT(mean, 0.05) << "of about 3 m";
  EXPECT_LT(mean, 0.5);
  EXPECT_LT(worst, 1.5);
}

TEST(Body, HasTheSameOdometryErrorInEachRunOfASeedAndNoErrorWithParametersOfZero) {
  Body one = body_at({}, 7);
  Body two = body_at({}, 7);
  run(one, walking(0.2, 0.05, 0.1), 5.0);
  run(two, walking(0.2, 0.05, 0.1), 5.0);
  EXPECT_EQ(one.odometry().position, two.odometry().position);

  BodyParameters perfect;
  perfect.odometry_scale_error = perfect.odometry_turn_bias = perfect.odometry_noise = 0.0;
  Body exact = body_at(Pose2(1.0, 1.0, 1.0), 7, perfect);
  run(exact, walking(0.2, 0.05, 0.1), 5.0);
  const Pose2 moved = Pose2(1.0, 1.0, 1.0).inverse() * exact.pose();
  EXPECT_LT((moved.position - exact.odometry().position).norm(), 1e-9);
}

TEST(Body, SwaysWhileItWalksAndStandsStillOtherwise) {
  Body body = body_at({});
  run(body, Request{}, 1.0);
  EXPECT_EQ(body.torso().roll, 0.0);
  double most = 0.0;
  for (int i = 0; i < 90; ++i) {
    body.advance(kStep, walking(0.25, 0.0, 0.0), {}, kBounds);
    most = std::max(most, std::abs(body.torso().roll));
  }
  EXPECT_NEAR(most, BodyParameters{}.sway_roll, 0.01);
}

TEST(Body, StaysInTheAirUntilItIsPlaced) {
  Body body = body_at(Pose2(1.0, 0.0, 0.0));
  body.pick_up();
  run(body, walking(0.25, 0.0, 0.0), 2.0);
  EXPECT_TRUE(body.ground_truth().carried);
  EXPECT_LT(felt(body).foot_load, 0.5);
  EXPECT_GT(body.torso_height(), 0.248 + 0.3);
  EXPECT_EQ(body.pose().position.x(), 1.0) << "a lifted robot does not walk";
  const Pose2 odometry = body.odometry();
  body.put_down(Pose2(-3.2, 3.5, -1.57));
  run(body, Request{}, 0.2);
  EXPECT_TRUE(body.ground_truth().carried) << "the operator lowers it";
  run(body, Request{}, 1.5);
  EXPECT_FALSE(body.ground_truth().carried);
  EXPECT_GT(felt(body).foot_load, 4.0);
  EXPECT_EQ(body.pose().position, Eigen::Vector2d(-3.2, 3.5));
  EXPECT_EQ(body.odometry().position, odometry.position) << "the odometry does not measure a lift";
}

TEST(Body, IsLiftedFromTheGroundWithoutAJolt) {
  constexpr double kSampled = 0.01;  // s
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Body body = body_at({}, seed);
    body.push_over();
    run(body, Request{}, seed % 3 == 0 ? 0.5 : 3.0);  // a third of them are still falling
    body.pick_up();
    for (double time = 0.0; time < 3.0; time += kSampled) {
      body.advance(kSampled, Request{}, {}, kBounds);
      const BodySample sample = felt(body);
      ASSERT_LT(sample.acceleration.norm(), 4.0 * kGravity) << "seed " << seed << ", after " << time << " s";
      ASSERT_LT(sample.angular_velocity.norm(), 6.0) << "seed " << seed << ", after " << time << " s";
    }
    EXPECT_GT(body.torso_height(), 0.248 + 0.3);
    EXPECT_LT(std::hypot(body.torso().roll, body.torso().pitch), 0.5);
  }
}

TEST(Body, FallsLiesAndGetsUpOnRequest) {
  Body body = body_at({}, 3);
  body.push_over();
  run(body, walking(0.2, 0.0, 0.0), 0.4);
  EXPECT_TRUE(body.ground_truth().fallen);
  run(body, walking(0.2, 0.0, 0.0), 3.0);
  EXPECT_EQ(body.posture(), Body::Posture::lying);
  EXPECT_GT(std::hypot(body.torso().roll, body.torso().pitch), 1.4);
  EXPECT_TRUE(body.pose().position.isZero());
  Request get_up;
  get_up.get_up = true;
  run(body, get_up, 3.0);
  EXPECT_TRUE(body.ground_truth().fallen);
  run(body, get_up, 3.5);
  EXPECT_FALSE(body.ground_truth().fallen);
  EXPECT_EQ(body.torso().pitch, 0.0);
}

TEST(Body, SlipsWhileItGetsUpWithoutMeasuringIt) {
  double turned = 0.0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Body body = body_at({}, seed);
    const double before = body.odometry().rotation;
    body.push_over();
    Request get_up;
    get_up.get_up = true;
    run(body, get_up, 9.0);
    ASSERT_EQ(body.posture(), Body::Posture::upright);
    turned += std::abs(body.pose().rotation) / 10.0;
    EXPECT_EQ(body.odometry().rotation, before);
  }
  EXPECT_GT(turned, 0.1);
}

TEST(Body, StandsStillWhilePenalized) {
  Body body = body_at({});
  body.penalize(true);
  run(body, walking(0.25, 0.1, 0.5), 2.0);
  EXPECT_TRUE(body.pose().position.isZero());
}

TEST(Body, StopsAtAPostAndSlidesAlongABar) {
  const std::vector<Barrier> post{{{1.0, 0.0}, {1.0, 0.0}, 0.05}};
  Body head_on = body_at({});
  run(head_on, walking(0.25, 0.0, 0.0), 10.0, post);
  EXPECT_NEAR(head_on.pose().position.x(), 1.0 - 0.05 - Body::kRadius, 1e-6);

  const std::vector<Barrier> bar{{{1.0, -5.0}, {1.0, 5.0}, 0.05}};
  Body aslant = body_at(Pose2(0.0, 0.0, 0.8));
  run(aslant, walking(0.25, 0.0, 0.0), 10.0, bar);
  EXPECT_NEAR(aslant.pose().position.x(), 0.8, 1e-6);
  EXPECT_GT(aslant.pose().position.y(), 1.0);
}

RC_GTEST_PROP(Body, NeverEndsUpInsideABarrierOrOutsideOfTheGround, ()) {
  const std::vector<Barrier> barriers{{{1.0, 0.3}, {1.0, 0.3}, 0.05}, {{-1.0, -1.0}, {-1.0, 1.0}, 0.02}};
  Body body = body_at(Pose2(0.0, 0.0, *rc::gen::inRange(-3000, 3000) * 1e-3));
  const Eigen::Vector2d bounds(1.5, 1.5);
  for (int leg = 0; leg < 8; ++leg) {
    const Request request = walking(*rc::gen::inRange(-30, 30) * 1e-2, *rc::gen::inRange(-20, 20) * 1e-2,
                                    *rc::gen::inRange(-80, 80) * 1e-2);
    for (int i = 0; i < 60; ++i) {
      body.advance(kStep, request, barriers, bounds);
      for (const Barrier& barrier : barriers) {
        RC_ASSERT(clearance(barrier, body.pose().position).distance > Body::kRadius - 1e-6);
      }
      RC_ASSERT((body.pose().position.cwiseAbs().array() <= 1.5).all());
    }
  }
}

}  // namespace
}  // namespace reorient

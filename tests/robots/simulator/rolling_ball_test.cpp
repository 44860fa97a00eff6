// SPDX-License-Identifier: MIT
#include "robots/simulator/ball/rolling_ball.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "robots/simulator/ball/field_exit.h"

namespace reorient {
namespace {

constexpr double kRollStep = 1.0 / 30.0;  // s
const Eigen::Vector2d kCarpet(5.2, 3.7);

RollingBall ball_at(const Eigen::Vector2d& position, const Eigen::Vector2d& velocity = Eigen::Vector2d::Zero()) {
  RollingBall ball;
  ball.position = position;
  ball.velocity = velocity;
  return ball;
}

void roll(RollingBall& ball, double seconds, const BallParameters& parameters = {},
          const std::vector<Barrier>& barriers = {}) {
  for (int i = 0; i < std::lround(seconds / kRollStep); ++i) ball.advance(kRollStep, parameters, barriers, kCarpet);
}

TEST(RollingBall, StopsAfterTheDistanceThatItsSpeedAndTheFrictionSet) {
  for (const double friction : {0.2, 0.35, 1.0}) {
    BallParameters parameters;
    parameters.friction = friction;
    RollingBall ball = ball_at({-4.0, 0.0}, {1.0, 0.0});
    roll(ball, 10.0, parameters);
    EXPECT_EQ(ball.velocity.norm(), 0.0);
    EXPECT_NEAR(ball.position.x() + 4.0, 1.0 / (2.0 * friction), 0.03) << friction;
  }
}

TEST(RollingBall, ReboundsFromAPostWithTheStatedFractionOfItsSpeed) {
  BallParameters parameters;
  parameters.friction = 0.02;
  const std::vector<Barrier> post{{{1.0, 0.0}, {1.0, 0.0}, 0.05}};
  RollingBall ball = ball_at({0.0, 0.0}, {1.0, 0.0});
  roll(ball, 1.5, parameters, post);
  EXPECT_NEAR(ball.velocity.x(), -0.5, 0.03);
  EXPECT_LT(ball.position.x(), 0.9);
}

TEST(RollingBall, DoesNotRollThroughANetAtAnySpeed) {
  const std::vector<Barrier> net{{{1.0, -1.0}, {1.0, 1.0}, 0.02}};
  for (const double speed : {0.5, 2.0, 6.0, 10.0}) {
    RollingBall ball = ball_at({0.0, 0.1}, {speed, 0.0});
    roll(ball, 3.0, {}, net);
    EXPECT_LT(ball.position.x(), 1.0) << speed;
  }
}

TEST(RollingBall, StaysOnTheCarpet) {
  RollingBall ball = ball_at({5.0, 3.5}, {3.0, 3.0});
  roll(ball, 3.0);
  EXPECT_EQ(ball.position, kCarpet);
  EXPECT_EQ(ball.velocity.norm(), 0.0);
}

TEST(RollingBall, IsPushedByARobotThatWalksIntoIt) {
  const BallParameters parameters;
  RollingBall ball = ball_at({0.19, 0.0});
  EXPECT_TRUE(ball.touch({0.0, 0.0}, 0.15, parameters));
  EXPECT_NEAR(ball.velocity.x(), parameters.push_speed, 1e-12);
  EXPECT_NEAR(ball.position.x(), 0.2, 1e-12);
  roll(ball, 0.1);
  EXPECT_FALSE(ball.touch({0.0, 0.0}, 0.15, parameters)) << "it has rolled away";
}

TEST(RollingBall, ReboundsFromAStandingRobot) {
  RollingBall ball = ball_at({0.18, 0.0}, {-2.0, 0.3});
  EXPECT_TRUE(ball.touch({0.0, 0.0}, 0.15, {}));
  EXPECT_NEAR(ball.velocity.x(), 1.0, 1e-12);
  EXPECT_NEAR(ball.velocity.y(), 0.3, 1e-12);
}

TEST(RollingBall, HasTheMassOfTheLeaguesBall) {
  EXPECT_EQ(ball_mass(0.1), 0.044);
  double last = 0.0;
  for (const double diameter : {0.1, 0.14, 0.19, 0.205, 0.22}) {
    EXPECT_GT(ball_mass(diameter), last) << diameter;
    last = ball_mass(diameter);
  }
}

TEST(FieldExit, NeedsTheWholeBallBeyondTheLine) {
  const FieldDimensions field;
  EXPECT_FALSE(exit_of(ball_at({4.57, 0.0}), field));
  EXPECT_FALSE(exit_of(ball_at({0.0, -3.07}), field));
  const auto exit = [&](double x, double y) { return exit_of(ball_at({x, y}), field).value(); };
  EXPECT_EQ(exit(4.58, 0.7).line, FieldExit::Line::goal);
  EXPECT_EQ(exit(4.58, 0.7).side, 1.0);
  EXPECT_EQ(exit(-4.58, 0.9).line, FieldExit::Line::goal_line);
  EXPECT_EQ(exit(-4.58, 0.9).side, -1.0);
  EXPECT_EQ(exit(1.0, -3.08).line, FieldExit::Line::touchline);
  EXPECT_EQ(exit(1.0, -3.08).side, -1.0);
}

}  // namespace
}  // namespace reorient

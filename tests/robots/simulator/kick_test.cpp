// SPDX-License-Identifier: MIT
#include "robots/simulator/ball/kick.h"

#include <cmath>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "geometry/angle.h"
#include "geometry/transform.h"
#include "robots/simulator/ball/rolling_ball.h"

namespace reorient {
namespace {

constexpr double kKickStep = 1.0 / 30.0;  // s
constexpr double kMass = 0.044;           // kg

struct Outcome {
  ActionState end = ActionState::idle;
  std::string reason;
  std::optional<Eigen::Vector2d> velocity;
  double hit_at = 0.0, ended_at = 0.0;  // s
  int running = 0;                      // reports
};

Outcome outcome_of(Kick& kick, const KickerState& kicker, const std::optional<Eigen::Vector2d>& ball) {
  Outcome outcome;
  for (int i = 1; i <= 300 && kick.is_active(); ++i) {
    const Kick::Progress progress = kick.advance(kKickStep, kicker, ball, kMass);
    if (progress.velocity) outcome.velocity = progress.velocity, outcome.hit_at = i * kKickStep;
    if (progress.state == ActionState::running) ++outcome.running;
    if (progress.state == ActionState::done || progress.state == ActionState::failed) {
      outcome.end = *progress.state;
      outcome.reason = progress.reason;
      outcome.ended_at = i * kKickStep;
    }
  }
  return outcome;
}

Outcome outcome_of(const KickerState& kicker, const std::optional<Eigen::Vector2d>& ball, Foot foot = Foot::nearest) {
  Kick kick({}, 1);
  kick.begin(foot, 0.0);
  return outcome_of(kick, kicker, ball);
}

TEST(Kick, HitsTheBallAfterTheDelayAndEndsAfterTheRecovery) {
  const KickParameters parameters;
  const Outcome outcome = outcome_of({}, Eigen::Vector2d(0.22, 0.06));
  EXPECT_EQ(outcome.end, ActionState::done);
  EXPECT_EQ(outcome.running, 1);
  ASSERT_TRUE(outcome.velocity);
  EXPECT_NEAR(outcome.hit_at, parameters.delay, 2.0 * kKickStep);
  EXPECT_NEAR(outcome.ended_at, parameters.delay + parameters.recovery, 3.0 * kKickStep);
}

TEST(Kick, GivesTheBallTheRequestedDirectionWithTheStatedErrors) {
  KickParameters parameters;
  KickerState kicker;
  kicker.pose = Pose2(1.0, 2.0, kPi / 2.0);
  double sum = 0.0, squares = 0.0, speed = 0.0;
  constexpr int kKicks = 400;
  Kick kick(parameters, 3);
  for (int i = 0; i < kKicks; ++i) {
    kick.begin(Foot::left, 0.4);
    const Outcome outcome = outcome_of(kick, kicker, kicker.pose * Eigen::Vector2d(0.22, 0.06));
    ASSERT_TRUE(outcome.velocity);
    const double error = angle_difference(direction_of(*outcome.velocity), kPi / 2.0 + 0.4);
    sum += error;
    squares += error * error;
    speed += outcome.velocity->norm() / kKicks;
  }
  EXPECT_NEAR(sum / kKicks, 0.0, 0.02);
  EXPECT_NEAR(std::sqrt(squares / kKicks), parameters.direction_noise, 0.015);
  EXPECT_NEAR(speed, 1.2 * 1.5 * 0.9 / (0.9 + kMass), 0.03);
}

TEST(Kick, OfAHeavierBallIsSlower) {
  KickParameters exact;
  exact.speed_noise = 0.0;
  double last = 10.0;
  for (const double mass : {0.044, 0.2, 0.43}) {
    Kick kick(exact, 1);
    kick.begin(Foot::nearest, 0.0);
    double speed = 0.0;
    while (kick.is_active()) {
      const Kick::Progress progress = kick.advance(kKickStep, {}, Eigen::Vector2d(0.2, 0.05), mass);
      if (progress.velocity) speed = progress.velocity->norm();
    }
    EXPECT_GT(speed, 0.5);
    EXPECT_LT(speed, last);
    last = speed;
  }
}

TEST(Kick, FailsWithAReasonIfTheFootCannotHitTheBall) {
  const auto reason_of = [](const Outcome& outcome) {
    EXPECT_EQ(outcome.end, ActionState::failed);
    EXPECT_FALSE(outcome.velocity);
    return outcome.reason;
  };
  EXPECT_EQ(
      reason_of(outcome_of({}, Eigen::Vector2d(0.5, 0.05))),
      "the ball is out of reach: 0.50 m ahead and 0.00 m beside the left foot (expected at most 0.28 m and 0.09 m)");
  EXPECT_EQ(
      reason_of(outcome_of({}, Eigen::Vector2d(0.2, -0.1), Foot::left)),
      "the ball is out of reach: 0.20 m ahead and 0.15 m beside the left foot (expected at most 0.28 m and 0.09 m)");
  EXPECT_NE(reason_of(outcome_of({}, Eigen::Vector2d(-0.2, 0.05))).find("out of reach"), std::string::npos);
  EXPECT_EQ(reason_of(outcome_of({}, std::nullopt)), "there is no ball");
  KickerState walking;
  walking.speed = 0.2;
  EXPECT_EQ(reason_of(outcome_of(walking, Eigen::Vector2d(0.2, 0.05))), "the robot walks");
  KickerState lying;
  lying.is_upright = false;
  EXPECT_EQ(reason_of(outcome_of(lying, Eigen::Vector2d(0.2, 0.05))), "the robot does not stand");
  KickerState lifted;
  lifted.is_upright = false;
  lifted.is_lifted = true;
  EXPECT_EQ(reason_of(outcome_of(lifted, Eigen::Vector2d(0.2, 0.05))), "the robot is lifted");
  KickerState penalized;
  penalized.is_penalized = true;
  EXPECT_EQ(reason_of(outcome_of(penalized, Eigen::Vector2d(0.2, 0.05))), "the robot is penalized");
}

}  // namespace
}  // namespace reorient

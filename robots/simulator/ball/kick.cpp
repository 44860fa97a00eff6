// SPDX-License-Identifier: MIT
#include "robots/simulator/ball/kick.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "geometry/transform.h"

namespace reorient {
namespace {

constexpr double kFootLeft = 0.05;  // m from the center of a NAO to the middle of a foot

/// Why a robot cannot kick, wherever the ball lies; empty: it can.
const char* hindrance_of(const KickerState& kicker) {
  if (kicker.is_penalized) return "the robot is penalized";
  if (kicker.is_lifted) return "the robot is lifted";
  return kicker.is_upright ? "" : "the robot does not stand";
}

}  // namespace

void Kick::begin(Foot foot, double direction) {
  phase_ = Phase::requested;
  foot_ = foot;
  direction_ = direction;
  since_ = 0.0;
}

Kick::Progress Kick::advance(double time_step, const KickerState& kicker, const std::optional<Eigen::Vector2d>& ball,
                             double mass) {
  if (phase_ == Phase::none) return {};
  if (std::string hindrance = hindrance_of(kicker); !hindrance.empty()) return fail(std::move(hindrance));
  since_ += time_step;
  if (phase_ == Phase::requested) {
    phase_ = Phase::swing;
    return {ActionState::running, "", std::nullopt};
  }
  if (phase_ == Phase::swing && since_ >= parameters_.delay) {
    if (std::string reason = obstacle(kicker, ball); !reason.empty()) return fail(std::move(reason));
    phase_ = Phase::recovery;
    since_ = 0.0;
    return {std::nullopt, "", hit(kicker, mass)};
  }
  if (phase_ == Phase::recovery && since_ >= parameters_.recovery) {
    phase_ = Phase::none;
    return {ActionState::done, "", std::nullopt};
  }
  return {};
}

std::string Kick::obstacle(const KickerState& kicker, const std::optional<Eigen::Vector2d>& ball) const {
  constexpr double kStanding = 0.05;  // m/s
  if (kicker.speed > kStanding) return "the robot walks";
  if (!ball) return "there is no ball";
  const Eigen::Vector2d in_robot = rotated(*ball - kicker.pose.position, -kicker.pose.rotation);
  const bool is_left = foot_ == Foot::nearest ? in_robot.y() > 0.0 : foot_ == Foot::left;
  const double beside = std::abs(in_robot.y() - (is_left ? kFootLeft : -kFootLeft) * kicker.size);
  if (in_robot.x() > 0.0 && in_robot.x() <= parameters_.reach * kicker.size && beside <= parameters_.side * kicker.size)
    return "";
  char text[160];
  std::snprintf(text, sizeof(text),
                "the ball is out of reach: %.2f m ahead and %.2f m beside the %s foot (expected at most %.2f m and "
                "%.2f m)",
                in_robot.x(), beside, is_left ? "left" : "right", parameters_.reach * kicker.size,
                parameters_.side * kicker.size);
  return text;
}

/// A leg hits a resting ball: the momentum of both, and the speed at which they part.
Eigen::Vector2d Kick::hit(const KickerState& kicker, double mass) {
  constexpr double kLegMass = 0.9;      // kg, of shank and foot of a NAO
  constexpr double kRestitution = 0.5;  // of a plastic foot and the ball
  const double leg = kLegMass * kicker.size * kicker.size * kicker.size;
  const double speed = parameters_.foot_speed * kicker.size * (1.0 + kRestitution) * leg / (leg + mass);
  const double speed_error = parameters_.speed_noise * random_.normal();
  const double direction_error = parameters_.direction_noise * random_.normal();
  return std::max(0.0, speed * (1.0 + speed_error)) * unit_vector(kicker.pose.rotation + direction_ + direction_error);
}

Kick::Progress Kick::fail(std::string reason) {
  phase_ = Phase::none;
  return {ActionState::failed, std::move(reason), std::nullopt};
}

}  // namespace reorient

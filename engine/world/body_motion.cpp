// SPDX-License-Identifier: MIT
#include "engine/world/body_motion.h"

#include <algorithm>
#include <cmath>

namespace reorient {
namespace {

constexpr double kMemory = 0.3;          // s; a step of a NAO takes about as long
constexpr double kHeadMemory = 0.1;      // s
constexpr double kStandingSpeed = 0.03;  // m/s; the odometry of a robot that sways
constexpr double kStandingTurn = 0.1;    // rad/s
constexpr double kStillHead = 0.1;       // rad/s; the joints of a NAO are measured to 0.1 degrees

double speed_of(double forward, double left) { return std::sqrt(forward * forward + left * left); }

}  // namespace

BodyMotion after_step(BodyMotion motion, const Pose2& moved, double step) {
  if (!(step > 0.0)) return motion;
  const double share = std::min(1.0, step / kMemory);
  const auto follow = [&](double& smooth, double now) { smooth += share * (now - smooth); };
  follow(motion.measured.forward, moved.position.x() / step);
  follow(motion.measured.left, moved.position.y() / step);
  follow(motion.measured.turn, moved.rotation / step);
  motion.speed = speed_of(motion.measured.forward, motion.measured.left);
  return motion;
}

BodyMotion after_turn_of_head(BodyMotion motion, const HeadAngles& turned, double step) {
  if (!(step > 0.0)) return motion;
  const double now = std::max(std::abs(turned.yaw), std::abs(turned.pitch)) / step;
  motion.head_speed += std::min(1.0, step / kHeadMemory) * (now - motion.head_speed);
  return motion;
}

BodyMotion after_request(BodyMotion motion, const WalkVelocity& walk) {
  motion.requested_speed = speed_of(walk.forward, walk.left);
  motion.requested_turn = walk.turn;
  return motion;
}

bool is_walking(const BodyMotion& motion) {
  return motion.requested_speed > 0.0 || motion.requested_turn != 0.0 || motion.speed > kStandingSpeed ||
         std::abs(motion.measured.turn) > kStandingTurn;
}

bool is_head_moving(const BodyMotion& motion) { return motion.head_speed > kStillHead; }

}  // namespace reorient

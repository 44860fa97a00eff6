// SPDX-License-Identifier: MIT
// The ball: robots push it, and the friction of the carpet slows it down.
#pragma once

#include <algorithm>

#include <Eigen/Core>

namespace reorient {

struct RollingBall {
  Eigen::Vector2d position{0.0, 0.0};  ///< m
  Eigen::Vector2d velocity{0.0, 0.0};  ///< m/s

  /// Advances by `time_step` seconds, within `bounds` (half sizes of the carpet, m).
  void advance(double time_step, const Eigen::Vector2d& bounds) {
    constexpr double kFriction = 0.35;  // m/s^2
    const double speed = velocity.norm();
    if (speed > 0.0) velocity *= std::max(0.0, speed - kFriction * time_step) / speed;
    position += time_step * velocity;
    for (int axis = 0; axis < 2; ++axis) {
      if (std::abs(position[axis]) <= bounds[axis]) continue;
      position[axis] = std::clamp(position[axis], -bounds[axis], bounds[axis]);
      velocity[axis] = 0.0;
    }
  }

  /// Lets a robot that touches the ball push it away.
  void touch(const Eigen::Vector2d& robot) {
    constexpr double kReach = 0.2;  // m between the centers of robot and ball
    constexpr double kPush = 0.45;  // m/s
    const Eigen::Vector2d apart = position - robot;
    const double distance = apart.norm();
    if (distance >= kReach || distance < 1e-6) return;
    position = robot + kReach / distance * apart;
    velocity = kPush / distance * apart;
  }
};

}  // namespace reorient

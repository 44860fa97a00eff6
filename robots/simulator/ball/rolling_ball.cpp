// SPDX-License-Identifier: MIT
#include "robots/simulator/ball/rolling_ball.h"

#include <algorithm>
#include <cmath>

namespace reorient {

double ball_mass(double diameter) {
  struct Size {
    double largest;  // m, of the diameter
    double mass;     // kg
  };
  constexpr Size kSizes[] = {{0.12, 0.044}, {0.16, 0.2}, {0.195, 0.32}, {0.21, 0.37}};
  constexpr double kSize5 = 0.43;  // kg
  for (const Size& size : kSizes) {
    if (diameter <= size.largest) return size.mass;
  }
  return kSize5;
}

void RollingBall::advance(double time_step, const BallParameters& parameters, std::span<const Barrier> barriers,
                          const Eigen::Vector2d& bounds) {
  // A fast ball takes several steps, so that it does not roll through a net.
  constexpr int kMostSteps = 20;
  const int steps = std::clamp(static_cast<int>(std::ceil(2.0 * velocity.norm() * time_step / radius)), 1, kMostSteps);
  for (int i = 0; i < steps; ++i) {
    roll(time_step / steps, parameters.friction, bounds);
    rebound(barriers, parameters.restitution);
  }
}

void RollingBall::roll(double time_step, double friction, const Eigen::Vector2d& bounds) {
  const double speed = velocity.norm();
  if (speed > 0.0) velocity *= std::max(0.0, speed - friction * time_step) / speed;
  position += time_step * velocity;
  for (int axis = 0; axis < 2; ++axis) {
    if (std::abs(position[axis]) <= bounds[axis]) continue;
    position[axis] = std::clamp(position[axis], -bounds[axis], bounds[axis]);
    velocity[axis] = 0.0;
  }
}

void RollingBall::rebound(std::span<const Barrier> barriers, double restitution) {
  for (const Barrier& barrier : barriers) {
    const Clearance clear = clearance(barrier, position);
    const double deep = radius - clear.distance;
    if (deep <= 0.0) continue;
    position += deep * clear.away;
    const double approach = -velocity.dot(clear.away);
    if (approach > 0.0) velocity += (1.0 + restitution) * approach * clear.away;
  }
}

bool RollingBall::touch(const Eigen::Vector2d& robot, double robot_radius, const BallParameters& parameters) {
  constexpr double kRolling = 0.05;  // m/s toward the robot, above which the ball is what moves
  const double reach = robot_radius + radius;
  const Eigen::Vector2d apart = position - robot;
  const double distance = apart.norm();
  if (distance >= reach || distance < 1e-6) return false;
  position = robot + reach / distance * apart;
  const Eigen::Vector2d away = apart / distance;
  const double approach = -velocity.dot(away);
  if (approach > kRolling) {
    velocity += (1.0 + parameters.restitution) * approach * away;
  } else {
    velocity = parameters.push_speed / distance * apart;
  }
  return true;
}

}  // namespace reorient

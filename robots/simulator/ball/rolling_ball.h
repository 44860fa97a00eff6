// SPDX-License-Identifier: MIT
// The ball: robots push and kick it, the carpet slows it down, and it rebounds from goals, furniture and robots.
#pragma once

#include <span>

#include <Eigen/Core>

#include "robots/simulator/body/barrier.h"

namespace reorient {

struct BallParameters {
  double friction = 0.35;
  double restitution = 0.5;
  double push_speed = 0.45;
};

template <typename Visit>
void describe(BallParameters& p, Visit&& visit) {
  // The default is that of the 2-D simulation in B-Human's code release: RoboCupCtrl::ballFriction.
  visit("friction", p.friction, 0.02, 5.0, "m/s^2", "deceleration of the rolling ball on the carpet");
  visit("restitution", p.restitution, 0.0, 1.0, "",
        "speed of the ball after a rebound from a goal, furniture or a robot, divided by the speed before");
  visit("push_speed", p.push_speed, 0.0, 2.0, "m/s", "speed of a ball into which a robot walks");
}

/// Mass of the ball in kg that the rules of the leagues require for a field with a ball of this diameter (m): the foam
/// ball of the Standard Platform League, and soccer balls of the sizes 1, 3, 4 and 5.
double ball_mass(double diameter);

struct RollingBall {
  Eigen::Vector2d position{0.0, 0.0};  ///< m
  Eigen::Vector2d velocity{0.0, 0.0};  ///< m/s
  double radius = 0.05;                ///< m

  /// Advances by `time_step` seconds, within `bounds` (half sizes of the carpet, m), where it stops.
  void advance(double time_step, const BallParameters& parameters, std::span<const Barrier> barriers,
               const Eigen::Vector2d& bounds);

  /// Lets a robot that touches the ball push it away, or the ball rebound from the robot. `robot_radius`: m. Returns
  /// whether they touched.
  bool touch(const Eigen::Vector2d& robot, double robot_radius, const BallParameters& parameters);

 private:
  void roll(double time_step, double friction, const Eigen::Vector2d& bounds);
  void rebound(std::span<const Barrier> barriers, double restitution);
};

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Robots that walk into each other may fall.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/pose2.h"
#include "geometry/random.h"

namespace reorient {

struct CollisionParameters {
  double fall_rate = 0.15;
};

template <typename Visit>
void describe(CollisionParameters& p, Visit&& visit) {
  visit("fall_rate", p.fall_rate, 0.0, 10.0, "1/s",
        "probability per second that a robot falls while it walks into another robot");
}

/// A robot as others meet it.
struct MovingRobot {
  Pose2 pose;
  double speed = 0.0;  ///< m/s
  bool is_upright = true;
};

/// The robots that fall in this step of `time_step` seconds. Robots touch at a distance of `contact` (m).
inline std::vector<std::size_t> falls(std::span<const MovingRobot> robots, double contact,
                                      const CollisionParameters& parameters, double time_step, Random& random) {
  constexpr double kWalking = 0.05;  // m/s
  std::vector<std::size_t> fallen;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    bool has_contact = false;
    for (std::size_t k = 0; k < robots.size(); ++k)
      has_contact |= i != k && (robots[i].pose.position - robots[k].pose.position).norm() < contact;
    if (!has_contact || !robots[i].is_upright || robots[i].speed < kWalking) continue;
    if (random.uniform() < parameters.fall_rate * time_step) fallen.push_back(i);
  }
  return fallen;
}

}  // namespace reorient

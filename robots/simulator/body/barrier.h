// SPDX-License-Identifier: MIT
// Obstacles that a robot cannot walk through.
#pragma once

#include <algorithm>

#include <Eigen/Core>

namespace reorient {

/// Everything on the ground within `radius` of a line segment; a post if both ends are the same. Meters.
struct Barrier {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  double radius = 0.05;
};

/// Distance of a point from the barrier's surface, m, and the unit vector that points away from the barrier.
struct Clearance {
  double distance = 0.0;  ///< negative inside
  Eigen::Vector2d away = Eigen::Vector2d::UnitX();
};

inline Clearance clearance(const Barrier& barrier, const Eigen::Vector2d& point) {
  const Eigen::Vector2d line = barrier.to - barrier.from;
  const double length2 = line.squaredNorm();
  const double fraction = length2 > 0.0 ? std::clamp((point - barrier.from).dot(line) / length2, 0.0, 1.0) : 0.0;
  const Eigen::Vector2d apart = point - barrier.from - fraction * line;
  const double distance = apart.norm();
  return {distance - barrier.radius, distance > 1e-9 ? Eigen::Vector2d(apart / distance) : Eigen::Vector2d::UnitX()};
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Adds random measurement errors to a measured position, for poses that are drawn from it.
#pragma once

#include <cmath>

#include "geometry/random.h"
#include "localization/measurement/measurement_model.h"
#include "localization/particles/particle_set.h"

namespace reorient {

/// A roughly normally distributed random number with mean 0.
inline double rough(double deviation, Random& random) { return deviation * static_cast<double>(rough_normal(random)); }

/// `place`: m, robot frame, nonzero. The errors are distributed as `observed` assumes.
inline Eigen::Vector2d disturbed(const Eigen::Vector2d& place, const MeasurementModel& observed, Random& random) {
  const double distance = place.norm();
  const Eigen::Vector2d sight = place / distance;
  const Eigen::Vector2d across(-sight.y(), sight.x());
  const double aside = rough(std::sqrt(observed.variance_across(distance)), random);
  const double farther = rough(std::sqrt(observed.variance_along(distance)), random);
  return place + sight * farther + across * aside;
}

}  // namespace reorient

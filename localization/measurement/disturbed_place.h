// SPDX-License-Identifier: MIT
// A measured place as it might really be, for poses that are drawn from it.
#pragma once

#include <cmath>

#include "geometry/random.h"
#include "localization/measurement/measurement_model.h"
#include "localization/particles/particle_set.h"

namespace reorient {

/// Drawn from a roughly normal distribution around 0.
inline double rough(double deviation, Random& random) { return deviation * static_cast<double>(rough_normal(random)); }

/// `place`: m, robot frame, not the robot itself. The errors are those of the model that has observed it.
inline Eigen::Vector2d disturbed(const Eigen::Vector2d& place, const MeasurementModel& observed, Random& random) {
  const double distance = place.norm();
  const Eigen::Vector2d sight = place / distance;
  const Eigen::Vector2d across(-sight.y(), sight.x());
  const double aside = rough(std::sqrt(observed.variance_across(distance)), random);
  const double farther = rough(std::sqrt(observed.variance_along(distance)), random);
  return place + sight * farther + across * aside;
}

}  // namespace reorient

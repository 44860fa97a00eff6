// SPDX-License-Identifier: MIT
// New pose particles where the room is known and the pose is not: each place on the field with the heading that the
// view gives it.
#pragma once

#include "geometry/field_dimensions.h"
#include "geometry/random.h"
#include "localization/measurement/goal_injection.h"
#include "localization/measurement/measurement_model.h"
#include "localization/pose_belief.h"

namespace reorient {

/// The heading, rad, of a robot at `position` (m, field frame) that looks there. `azimuth`: on the wall, rad.
double heading_of_view(const SeenView& view, const Eigen::Vector2d& position, double azimuth);

class ViewInjection {
 public:
  explicit ViewInjection(const FieldDimensions& field);

  /// A pose on the carpet that fits the view and, of some drawn at random, the observations best. The first half is
  /// drawn anywhere, the second half around the best of the first.
  Pose2 draw(const SeenView& view, const MeasurementModel& observed, const InjectionParameters& parameters,
             Random& random);

 private:
  Eigen::Vector2d carpet_;  // half of its size, m
  BestCandidate best_;
};

}  // namespace reorient

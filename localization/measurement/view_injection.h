// SPDX-License-Identifier: MIT
// New pose particles for a lost robot in a known room: random positions on the field, with the heading that the view
// determines for each.
#pragma once

#include "geometry/field_dimensions.h"
#include "geometry/random.h"
#include "localization/measurement/goal_injection.h"
#include "localization/measurement/measurement_model.h"
#include "localization/pose_belief.h"

namespace reorient {

/// The heading, rad, of a robot at `position` (m, field frame) that looks at `azimuth` (rad, on the wall).
double heading_of_view(const SeenView& view, const Eigen::Vector2d& position, double azimuth);

class ViewInjection {
 public:
  explicit ViewInjection(const FieldDimensions& field);

  /// Draws some random poses on the carpet that fit the view, and returns the one that fits the observations best.
  /// The first half is drawn anywhere, the second half around the best of the first half.
  Pose2 draw(const SeenView& view, const MeasurementModel& observed, const InjectionParameters& parameters,
             Random& random);

 private:
  Eigen::Vector2d carpet_;  // half of its size, m
  BestCandidate best_;
};

}  // namespace reorient

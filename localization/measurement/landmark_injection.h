// SPDX-License-Identifier: MIT
// New pose particles from intersections of lines and from the center circle.
#pragma once

#include <cstddef>
#include <optional>

#include "geometry/random.h"
#include "localization/measurement/best_candidate.h"
#include "localization/measurement/goal_injection.h"
#include "localization/measurement/landmark_poses.h"
#include "localization/measurement/measurement_model.h"
#include "perception/field/percepts.h"

namespace reorient {

/// Draws poses that agree with the observed position and direction of a landmark. Each landmark of this type on the
/// field gives one such pose.
class LandmarkInjection {
 public:
  explicit LandmarkInjection(const FieldDimensions& field);

  /// Number of landmarks of the percept from which a pose can be computed.
  static std::size_t landmarks(const FieldPercept& percept);

  /// Draws some random poses that explain one of the landmarks within its measurement errors, and returns the one
  /// that explains the other observations best. Empty without a landmark, or if all of the poses are off the carpet.
  std::optional<Pose2> draw(const FieldPercept& percept, const MeasurementModel& observed,
                            const InjectionParameters& parameters, Random& random);

 private:
  std::optional<Pose2> draw_candidate(const FieldPercept& percept, const MeasurementModel& observed,
                                      Random& random) const;

  IntersectionsByKind intersections_;
  Eigen::Vector2d carpet_;  // half of its size, m
  BestCandidate best_;
};

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Draws poses where intersections of lines and the center circle say that the robot stands.
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

/// A landmark as one frame shows it: a place and a direction, which together give a pose for each such landmark of the
/// field.
class LandmarkInjection {
 public:
  explicit LandmarkInjection(const FieldDimensions& field);

  /// How many landmarks of the percept give a pose.
  static std::size_t landmarks(const FieldPercept& percept);

  /// A pose that explains one of the landmarks, as the errors of its measurement allow, and, of some drawn at random,
  /// the rest of the observations best. Nothing: there is no landmark, or all of the drawn poses are off the carpet.
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

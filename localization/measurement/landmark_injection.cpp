// SPDX-License-Identifier: MIT
#include "localization/measurement/landmark_injection.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/transform.h"
#include "localization/measurement/disturbed_place.h"

namespace reorient {
namespace {

constexpr double kDirectionDeviation = 0.08;  // rad, of an intersection's direction

bool is_usable(const Eigen::Vector2d& place, double direction) {
  return place.norm() > 0.1 && std::isfinite(place.squaredNorm() + direction);
}

bool is_usable(const Intersection& seen) { return is_usable(seen.position, seen.direction); }

/// Usable only together with the halfway line.
bool is_usable(const std::optional<CenterCircle>& circle) {
  return circle && circle->halfway_direction && is_usable(circle->center, *circle->halfway_direction);
}

}  // namespace

LandmarkInjection::LandmarkInjection(const FieldDimensions& field)
    : intersections_(field), carpet_(carpet_half_size(field)) {}

std::size_t LandmarkInjection::landmarks(const FieldPercept& percept) {
  const auto usable = std::count_if(percept.intersections.begin(), percept.intersections.end(),
                                    [](const Intersection& seen) { return is_usable(seen); });
  return static_cast<std::size_t>(usable) + (is_usable(percept.center_circle) ? 1 : 0);
}

std::optional<Pose2> LandmarkInjection::draw_candidate(const FieldPercept& percept, const MeasurementModel& observed,
                                                       Random& random) const {
  std::size_t skipped = random.below(landmarks(percept));
  if (is_usable(percept.center_circle) && skipped-- == 0) {
    const CenterCircle& circle = *percept.center_circle;
    const double direction = *circle.halfway_direction + rough(std::sqrt(circle.direction_variance), random);
    const double halfway = draw_halfway_direction(random);
    return pose_from_landmark(Eigen::Vector2d::Zero(), halfway, disturbed(circle.center, observed, random), direction);
  }
  const auto seen = std::find_if(percept.intersections.begin(), percept.intersections.end(),
                                 [&skipped](const Intersection& one) { return is_usable(one) && skipped-- == 0; });
  const FieldIntersection* const known = intersections_.draw(seen->kind, random);
  if (known == nullptr) return std::nullopt;
  double direction = seen->direction + rough(kDirectionDeviation, random);
  direction += draw_turn(seen->kind, random);
  return pose_from_landmark(known->position, known->direction, disturbed(seen->position, observed, random), direction);
}

std::optional<Pose2> LandmarkInjection::draw(const FieldPercept& percept, const MeasurementModel& observed,
                                             const InjectionParameters& parameters, Random& random) {
  if (landmarks(percept) == 0) return std::nullopt;
  const auto count = static_cast<std::size_t>(std::max(1, parameters.candidates));
  const auto best = best_.choose(count, observed, [&]() -> std::optional<Pose2> {
    const std::optional<Pose2> candidate = draw_candidate(percept, observed, random);
    const bool is_on_carpet = candidate && (candidate->position.cwiseAbs().array() <= carpet_.array()).all();
    return is_on_carpet ? candidate : std::nullopt;
  });
  return best ? std::optional(best->pose) : std::nullopt;
}

}  // namespace reorient

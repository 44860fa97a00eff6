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

/// The circle with its halfway line.
bool is_usable(const std::optional<CenterCircle>& circle) {
  return circle && circle->halfway_direction && is_usable(circle->center, *circle->halfway_direction);
}

Pose2 pose_from(const Eigen::Vector2d& known, double known_direction, const Eigen::Vector2d& seen,
                double seen_direction) {
  const double rotation = angle_difference(known_direction, seen_direction);
  return {known - rotated(seen, rotation), rotation};
}

}  // namespace

LandmarkInjection::LandmarkInjection(const FieldDimensions& field)
    : intersections_(field_intersections(field)), carpet_(carpet_half_size(field)) {}

std::size_t LandmarkInjection::landmarks(const FieldPercept& percept) {
  const auto usable = std::count_if(percept.intersections.begin(), percept.intersections.end(),
                                    [](const Intersection& seen) { return is_usable(seen); });
  return static_cast<std::size_t>(usable) + (is_usable(percept.center_circle) ? 1 : 0);
}

std::optional<Pose2> LandmarkInjection::draw_candidate(const FieldPercept& percept, const MeasurementModel& observed,
                                                       Random& random) const {
  std::size_t wanted = random.below(landmarks(percept));
  if (is_usable(percept.center_circle) && wanted-- == 0) {
    const CenterCircle& circle = *percept.center_circle;
    const double direction = *circle.halfway_direction + rough(std::sqrt(circle.direction_variance), random);
    const double halfway = random.below(2) == 0 ? kPi / 2.0 : -kPi / 2.0;
    return pose_from(Eigen::Vector2d::Zero(), halfway, disturbed(circle.center, observed, random), direction);
  }
  const auto seen = std::find_if(percept.intersections.begin(), percept.intersections.end(),
                                 [&wanted](const Intersection& one) { return is_usable(one) && wanted-- == 0; });
  const auto fits = [&](const FieldIntersection& one) { return one.kind == seen->kind; };
  const auto count = std::count_if(intersections_.begin(), intersections_.end(), fits);
  if (count == 0) return std::nullopt;
  std::size_t chosen = random.below(static_cast<std::size_t>(count));
  const auto known = std::find_if(intersections_.begin(), intersections_.end(),
                                  [&](const FieldIntersection& one) { return fits(one) && chosen-- == 0; });
  double direction = seen->direction + rough(kDirectionDeviation, random);
  if (seen->kind == IntersectionKind::x) direction += kPi / 2.0 * static_cast<double>(random.below(4));
  return pose_from(known->position, known->direction, disturbed(seen->position, observed, random), direction);
}

std::optional<Pose2> LandmarkInjection::draw(const FieldPercept& percept, const MeasurementModel& observed,
                                             const InjectionParameters& parameters, Random& random) {
  if (landmarks(percept) == 0) return std::nullopt;
  const auto wanted = static_cast<std::size_t>(std::max(1, parameters.candidates));
  if (candidates_.size() != wanted) candidates_ = ParticleSet(wanted);
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < wanted; ++i) {
    const std::optional<Pose2> candidate = draw_candidate(percept, observed, random);
    if (candidate && (candidate->position.cwiseAbs().array() <= carpet_.array()).all())
      candidates_.set_pose(drawn++, *candidate);
  }
  if (drawn == 0) return std::nullopt;
  observed.costs(candidates_, costs_);
  const auto best = std::min_element(costs_.begin(), costs_.begin() + static_cast<std::ptrdiff_t>(drawn));
  return candidates_.pose(static_cast<std::size_t>(best - costs_.begin()));
}

}  // namespace reorient

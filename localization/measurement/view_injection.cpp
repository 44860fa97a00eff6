// SPDX-License-Identifier: MIT
#include "localization/measurement/view_injection.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "geometry/angle.h"
#include "geometry/transform.h"
#include "localization/measurement/disturbed_place.h"

namespace reorient {
namespace {

constexpr double kBesideBest = 0.5;         // m, standard deviation
constexpr double kTurnedBesideBest = 0.15;  // rad

}  // namespace

double heading_of_view(const SeenView& view, const Eigen::Vector2d& position, double azimuth) {
  return angle_difference(direction_of(view.radius * unit_vector(azimuth) - position), view.direction);
}

ViewInjection::ViewInjection(const FieldDimensions& field) : carpet_(carpet_half_size(field)) {}

Pose2 ViewInjection::draw(const SeenView& view, const MeasurementModel& observed, const InjectionParameters& parameters,
                          Random& random) {
  const auto half = static_cast<std::size_t>(std::max(1, parameters.candidates / 2));
  const auto anywhere = best_.choose(half, observed, [&] {
    const double x = random.uniform(-carpet_.x(), carpet_.x());
    const double y = random.uniform(-carpet_.y(), carpet_.y());
    const double azimuth = view.azimuth + rough(view.deviation, random);
    return std::optional(Pose2({x, y}, heading_of_view(view, {x, y}, azimuth)));
  });
  const Pose2& center = anywhere->pose;
  const auto beside = best_.choose(half, observed, [&] {
    const double x = center.position.x() + rough(kBesideBest, random);
    const double y = center.position.y() + rough(kBesideBest, random);
    const double turn = rough(kTurnedBesideBest, random);
    return std::optional(Pose2(Eigen::Vector2d(x, y).cwiseMax(-carpet_).cwiseMin(carpet_), center.rotation + turn));
  });
  return beside->cost < anywhere->cost ? beside->pose : anywhere->pose;
}

}  // namespace reorient

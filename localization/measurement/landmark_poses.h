// SPDX-License-Identifier: MIT
// Where a robot stands that sees an intersection or the center circle, if it is this one of the field.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "geometry/angle.h"
#include "geometry/field_landmarks.h"
#include "geometry/pose2.h"
#include "geometry/random.h"
#include "geometry/transform.h"

namespace reorient {

/// The intersections of the field, to be drawn by their kind.
class IntersectionsByKind {
 public:
  explicit IntersectionsByKind(const FieldDimensions& field) : all_(field_intersections(field)) {}

  /// Any of that kind, each equally likely. Null: the field has none.
  const FieldIntersection* draw(IntersectionKind kind, Random& random) const {
    const auto fits = [kind](const FieldIntersection& one) { return one.kind == kind; };
    const auto count = std::count_if(all_.begin(), all_.end(), fits);
    if (count == 0) return nullptr;
    std::size_t chosen = random.below(static_cast<std::size_t>(count));
    return &*std::find_if(all_.begin(), all_.end(),
                          [&](const FieldIntersection& one) { return fits(one) && chosen-- == 0; });
  }

 private:
  std::vector<FieldIntersection> all_;
};

/// rad: an X looks the same after a quarter turn, the others do not.
inline double draw_turn(IntersectionKind kind, Random& random) {
  return kind == IntersectionKind::x ? kPi / 2.0 * static_cast<double>(random.below(4)) : 0.0;
}

/// rad, field frame: along the halfway line, which is known up to half a turn.
inline double draw_halfway_direction(Random& random) { return random.below(2) == 0 ? kPi / 2.0 : -kPi / 2.0; }

/// From a landmark's place and direction, as known (field frame) and as seen (robot frame).
inline Pose2 pose_from_landmark(const Eigen::Vector2d& known, double known_direction, const Eigen::Vector2d& seen,
                                double seen_direction) {
  const double rotation = angle_difference(known_direction, seen_direction);
  return {known - rotated(seen, rotation), rotation};
}

}  // namespace reorient

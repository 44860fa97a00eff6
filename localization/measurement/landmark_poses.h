// SPDX-License-Identifier: MIT
// The pose of a robot that sees an intersection or the center circle, if it is a given one of the field.
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

/// The intersections of the field, to be drawn by their type.
class IntersectionsByKind {
 public:
  explicit IntersectionsByKind(const FieldDimensions& field) : all_(field_intersections(field)) {}

  /// A random one of this type, each equally likely. Null if the field has no such intersection.
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

/// rad: a random multiple of a quarter turn for an X, which looks the same then, and 0 for the others.
inline double draw_turn(IntersectionKind kind, Random& random) {
  return kind == IntersectionKind::x ? kPi / 2.0 * static_cast<double>(random.below(4)) : 0.0;
}

/// rad, field frame: one of the two directions of the halfway line, at random.
inline double draw_halfway_direction(Random& random) { return random.below(2) == 0 ? kPi / 2.0 : -kPi / 2.0; }

/// The robot's pose from a landmark's known position and direction (field frame) and the observed ones (robot frame).
inline Pose2 pose_from_landmark(const Eigen::Vector2d& known, double known_direction, const Eigen::Vector2d& seen,
                                double seen_direction) {
  const double rotation = angle_difference(known_direction, seen_direction);
  return {known - rotated(seen, rotation), rotation};
}

}  // namespace reorient

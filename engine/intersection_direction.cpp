// SPDX-License-Identifier: MIT
#include "engine/intersection_direction.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/transform.h"

namespace reorient {
namespace {

constexpr double kNearestArm = 0.12, kFarthestArm = 1.0;  // m from the intersection
constexpr double kOffArm = 0.08;                          // m, largest distance of a point from its arm
constexpr int kFewestOnArm = 2;

/// Number of line points on each of four arms at right angles. `first`: direction of arm 0, rad.
struct Arms {
  double first = 0.0;
  std::array<int, 4> points{};
};

/// Calls use(offset) for the line points on lines through the position.
template <typename Use>
void for_radial(const Eigen::Vector2d& position, const std::array<FieldPercept, 2>& percepts, Use&& use) {
  for (const FieldPercept& percept : percepts) {
    for (const LinePoint& point : percept.line_points) {
      const Eigen::Vector2d offset = point.position - position;
      const double far = offset.norm();
      if (far < kNearestArm || far > kFarthestArm) continue;
      if (std::abs(offset.dot(unit_vector(point.normal))) < kOffArm) use(offset);
    }
  }
}

Arms arms_at(const Eigen::Vector2d& position, const std::array<FieldPercept, 2>& percepts) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();  // of directions times four: those of all arms are equal
  for_radial(position, percepts,
             [&](const Eigen::Vector2d& offset) { sum += unit_vector(4.0 * direction_of(offset)); });
  Arms arms;
  if (sum.norm() < 1e-9) return arms;
  arms.first = 0.25 * direction_of(sum);
  for_radial(position, percepts, [&](const Eigen::Vector2d& offset) {
    const double turned = normalize_angle(direction_of(offset) - arms.first);
    const auto arm = static_cast<int>(std::lround(turned / (0.5 * kPi)));  // -2 to 2
    ++arms.points[static_cast<std::size_t>((arm + 4) % 4)];
  });
  return arms;
}

}  // namespace

std::optional<double> direction_from_lines(IntersectionKind kind, const Eigen::Vector2d& position,
                                           const std::array<FieldPercept, 2>& percepts) {
  const Arms arms = arms_at(position, percepts);
  const auto points = [&](std::size_t arm) { return arms.points[arm % 4]; };
  const auto direction = [&](double arm) { return normalize_angle(arms.first + 0.5 * kPi * arm); };
  if (kind == IntersectionKind::x) {
    const bool both = std::max(points(0), points(2)) >= kFewestOnArm && std::max(points(1), points(3)) >= kFewestOnArm;
    return both ? std::optional(direction(0.0)) : std::nullopt;
  }
  std::size_t best = 0;
  if (kind == IntersectionKind::l) {
    for (std::size_t arm = 1; arm < 4; ++arm) {
      if (std::min(points(arm), points(arm + 1)) > std::min(points(best), points(best + 1))) best = arm;
    }
    const bool is_clear = std::min(points(best), points(best + 1)) >= kFewestOnArm &&
                          std::max(points(best + 2), points(best + 3)) < kFewestOnArm;
    return is_clear ? std::optional(direction(static_cast<double>(best) + 0.5)) : std::nullopt;
  }
  // Of a T: the arm without an opposite one.
  for (std::size_t arm = 1; arm < 4; ++arm) {
    if (points(arm) - points(arm + 2) > points(best) - points(best + 2)) best = arm;
  }
  const bool is_clear = points(best) >= kFewestOnArm && points(best + 2) < kFewestOnArm &&
                        points(best + 1) + points(best + 3) >= kFewestOnArm;
  return is_clear ? std::optional(direction(static_cast<double>(best))) : std::nullopt;
}

}  // namespace reorient

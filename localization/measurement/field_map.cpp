// SPDX-License-Identifier: MIT
#include "localization/measurement/field_map.h"

#include <limits>
#include <stdexcept>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"
#include "geometry/transform.h"

namespace reorient {
namespace {

/// Errors of a normal up to the tolerance (rad) are ignored, since normals of percepts are noisy and the bins of
/// directions are wide. Each radian more counts as this many meters of distance.
constexpr double kDirectionTolerance = 25.0 * kPi / 180.0;
constexpr double kMetersPerRadian = 0.6;

/// Distance of a line from one position, and the direction of its normal there.
struct NearLine {
  double distance = 0.0;
  double normal = 0.0;
};

double direction_mismatch(double normal, double other) {
  return std::abs(std::remainder(normal - other, kPi));  // the sign of a normal is unknown
}

double distance_to(const FieldLine& line, const Eigen::Vector2d& place) {
  const Eigen::Vector2d along = line.to - line.from;
  const double fraction = std::clamp((place - line.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (place - line.from - fraction * along).norm();
}

double normal_of(const FieldLine& line) {
  const Eigen::Vector2d along = line.to - line.from;
  return pinned::atan2(along.x(), -along.y());
}

/// Distance to the nearest of these marks, from any direction.
double distance_to_marks(const std::vector<Eigen::Vector2d>& marks, double size, const Eigen::Vector2d& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& mark : marks) nearest = std::min(nearest, (place - mark).norm());
  return std::max(0.0, nearest - size / 2.0);
}

/// The corner arc of the quarter in which both coordinates are positive; it ends at the lines.
NearLine corner_arc(const FieldDimensions& field, const Eigen::Vector2d& place) {
  const Eigen::Vector2d from_corner = place - field_half_size(field);
  if (field.corner_arc_radius <= 0.0 || from_corner.maxCoeff() > 0.0) return {FieldMap::kMaxDistance, 0.0};
  return {std::abs(from_corner.norm() - field.corner_arc_radius), direction_of(from_corner)};
}

double distance_to_lines(const std::vector<NearLine>& lines, double normal) {
  double nearest = FieldMap::kMaxDistance;
  for (const NearLine& line : lines) {
    if (line.distance >= nearest) continue;
    const double excess = std::max(0.0, direction_mismatch(normal, line.normal) - kDirectionTolerance);
    nearest = std::min(nearest, line.distance + kMetersPerRadian * excess);
  }
  return nearest;
}

bool is_size(double meters) { return meters > 0.0 && meters <= 200.0; }

}  // namespace

FieldMap::FieldMap(const FieldDimensions& field) {
  if (!is_size(field.length) || !is_size(field.width) || !(field.border >= 0.0 && field.border <= 50.0)) {
    throw std::invalid_argument("field map: expected length and width in (0, 200] m and border in [0, 50] m");
  }
  const Eigen::Vector2d half_size = field_half_size(field) + Eigen::Vector2d(std::max(0.0, field.goal_depth), 0.0) +
                                    Eigen::Vector2d::Constant(kMaxDistance);
  columns_ = static_cast<int>(std::ceil(half_size.x() / kCellSize)) + 1;
  rows_ = static_cast<int>(std::ceil(half_size.y() / kCellSize)) + 1;
  last_column_ = static_cast<float>(columns_ - 1);
  last_row_ = static_cast<float>(rows_ - 1);
  cells_.resize(static_cast<std::size_t>(kDirections) * static_cast<std::size_t>(rows_) *
                static_cast<std::size_t>(columns_));

  std::vector<FieldLine> lines = field_lines(field);
  // The white tubes on the carpet that hold a goal's net look like lines, mostly for a robot in front of them.
  add_areas(field, -field.goal_depth, 2.0 * field.goal_post_y, lines);
  const std::vector<Eigen::Vector2d> marks = penalty_marks(field);
  std::vector<double> normals;
  normals.reserve(lines.size());
  for (const FieldLine& line : lines) normals.push_back(normal_of(line));
  std::vector<NearLine> near_lines;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const Eigen::Vector2d place((column + 0.5) * kCellSize, (row + 0.5) * kCellSize);
      near_lines.clear();
      for (std::size_t i = 0; i < lines.size(); ++i) {
        if (const double distance = distance_to(lines[i], place); distance < kMaxDistance)
          near_lines.push_back({distance, normals[i]});
      }
      near_lines.push_back({std::abs(place.norm() - field.center_circle_radius), direction_of(place)});
      near_lines.push_back(corner_arc(field, place));
      const double mark = distance_to_marks(marks, field.penalty_mark_size, place);
      for (int direction = 0; direction < kDirections; ++direction) {
        const double distance = std::min(mark, distance_to_lines(near_lines, direction * kPi / kDirections));
        const int cell = (direction * rows_ + row) * columns_ + column;
        cells_[static_cast<std::size_t>(cell)] = static_cast<std::uint8_t>(std::lround(distance / kStep));
      }
    }
  }
}

}  // namespace reorient

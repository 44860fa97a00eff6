// SPDX-License-Identifier: MIT
// The distance of a position on the field from the nearest line with a given direction.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "geometry/field_landmarks.h"
#include "localization/particles/binary_angle.h"

namespace reorient {

/// Likelihood fields (Probabilistic Robotics, chapter 6.4), one for each of 16 directions of a line's normal. They
/// contain the distance to the nearest line, where a line counts as farther the more its direction differs. Only the
/// quarter x, y >= 0 is stored; the rest is its mirror image. So the map is exactly the same from a mirrored pose.
class FieldMap {
 public:
  static constexpr int kDirections = 16;        ///< of a normal, whose sign is unknown
  static constexpr double kCellSize = 0.04;     ///< m
  static constexpr double kMaxDistance = 1.02;  ///< m; larger distances are reduced to it

  /// Throws std::invalid_argument if the field's length or width is not in (0, 200] m, or its border not in [0, 50] m.
  explicit FieldMap(const FieldDimensions& field);

  /// Index of the distance between the position (x, y), m, field frame, and lines with about this normal. Without
  /// branches and memory accesses, so that a loop over many positions can be vectorized.
  std::int32_t index(float x, float y, BinaryAngle normal) const {
    const auto column = static_cast<std::int32_t>(std::min(std::abs(x) * kCellsPerMeter, last_column_));
    const auto row = static_cast<std::int32_t>(std::min(std::abs(y) * kCellsPerMeter, last_row_));
    const auto direction = static_cast<std::int32_t>((normal * 2 + kHalfBin) >> 28);
    const std::int32_t mirrored = x * y < 0.0f ? -direction & (kDirections - 1) : direction;
    return (mirrored * rows_ + row) * columns_ + column;
  }
  /// The distance at an index, in steps of kStep.
  std::uint8_t steps_at(std::int32_t index) const { return cells_[static_cast<std::size_t>(index)]; }
  std::uint8_t steps(float x, float y, BinaryAngle normal) const { return steps_at(index(x, y, normal)); }
  static constexpr double kStep = kMaxDistance / 255.0;  ///< m

  /// Distance, m, from `place` to the nearest line with about this normal.
  double distance(const Eigen::Vector2d& place, double normal) const {
    return kStep * steps(static_cast<float>(place.x()), static_cast<float>(place.y()), to_binary_angle(normal));
  }

 private:
  static constexpr auto kCellsPerMeter = static_cast<float>(1.0 / kCellSize);
  static constexpr BinaryAngle kHalfBin = 1u << 27;

  std::int32_t columns_ = 0;
  std::int32_t rows_ = 0;
  float last_column_ = 0.0f;
  float last_row_ = 0.0f;
  std::vector<std::uint8_t> cells_;  ///< [direction][row][column]
};

}  // namespace reorient

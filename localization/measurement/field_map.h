// SPDX-License-Identifier: MIT
// How far a place on the field is from the nearest line of a given direction.
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

/// Likelihood fields (Probabilistic Robotics, chapter 6.4), one for each of 16 directions of a line's normal: the
/// distance to the nearest line, to which a line counts as farther the more its direction differs. Only the quarter
/// x, y >= 0 is stored, the rest is its mirror image: the map cannot but look the same from a reflected pose.
class FieldMap {
 public:
  static constexpr int kDirections = 16;        ///< of a normal, which is known up to half a turn
  static constexpr double kCellSize = 0.04;     ///< m
  static constexpr double kMaxDistance = 1.02;  ///< m; what is farther from all lines counts as this far

  /// Throws std::invalid_argument where the field's size is not in (0, 200] m.
  explicit FieldMap(const FieldDimensions& field);

  /// Where the distance of (x, y), m on the field, from lines with about this normal is stored. Without branches and
  /// memory accesses, so that a loop over many places can be vectorised.
  std::int32_t index(float x, float y, BinaryAngle normal) const {
    const auto column = static_cast<std::int32_t>(std::min(std::abs(x) * kCellsPerMetre, last_column_));
    const auto row = static_cast<std::int32_t>(std::min(std::abs(y) * kCellsPerMetre, last_row_));
    const auto direction = static_cast<std::int32_t>((normal * 2 + kHalfBin) >> 28);
    const std::int32_t mirrored = x * y < 0.0f ? -direction & (kDirections - 1) : direction;
    return (mirrored * rows_ + row) * columns_ + column;
  }
  /// That distance, in steps of kStep.
  std::uint8_t steps_at(std::int32_t index) const { return cells_[static_cast<std::size_t>(index)]; }
  std::uint8_t steps(float x, float y, BinaryAngle normal) const { return steps_at(index(x, y, normal)); }
  static constexpr double kStep = kMaxDistance / 255.0;  ///< m

  /// Distance in metres from `place` to the nearest line with about this normal.
  double distance(const Eigen::Vector2d& place, double normal) const {
    return kStep * steps(static_cast<float>(place.x()), static_cast<float>(place.y()), to_binary_angle(normal));
  }

 private:
  static constexpr auto kCellsPerMetre = static_cast<float>(1.0 / kCellSize);
  static constexpr BinaryAngle kHalfBin = 1u << 27;

  std::int32_t columns_ = 0;
  std::int32_t rows_ = 0;
  float last_column_ = 0.0f;
  float last_row_ = 0.0f;
  std::vector<std::uint8_t> cells_;  ///< [direction][row][column]
};

}  // namespace reorient

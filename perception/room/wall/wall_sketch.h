// SPDX-License-Identifier: MIT
// Where rays meet the wall, in single precision and with bounds of the error: a floating-point filter. What it is sure
// of is what exact computation finds, at a tenth of the time; for the rest there is Wall::meet. It exists in versions
// for several processors, and for any other one nothing is sure.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "geometry/transform.h"
#include "perception/room/instructions.h"
#include "perception/room/wall/sketching_kernels.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// Between the rays of one band of the image.
inline constexpr int kBandCells = 40;

/// The rays of one band, from the left to the right, with a cell between each two neighbors: scaled to (1, y, z) in the
/// camera frame.
class BandRays {
 public:
  /// Nothing if there are not kBandCells + 1, or if one leads backward, or so far off the axis that its bounds do not
  /// hold.
  static std::optional<BandRays> of(std::span<const Eigen::Vector3d> rays);

  const float* y() const { return y_.data(); }
  const float* z() const { return z_.data(); }
  /// The greatest that up(y, z) = from + y * by_y + z * by_z can be among them, or a little more.
  float highest(float from, float by_y, float by_z) const;

 private:
  std::array<float, kSketchedRays> y_{}, z_{};  // the last ray fills them up
  float y_least_ = 0.0f, y_most_ = 0.0f, z_least_ = 0.0f, z_most_ = 0.0f;
};

class WallSketch {
 public:
  /// Neither on a tile nor surely off the wall.
  static constexpr int kUnsure = kNowhereSure;
  static constexpr int kBelow = kBelowTheTiles;
  static constexpr int kAbove = kAboveTheTiles;

  /// `instructions`: must be offered.
  explicit WallSketch(Instructions instructions = widest_instructions());

  /// One frame.
  void prepare(const Wall& wall, const Isometry3& field_from_camera);
  /// One band of it. False if all of it is below the tiles: then there is nothing more to ask.
  bool draw(const BandRays& rays);
  /// Instead: nothing is sure.
  void leave_blank();

  /// The tile on which a ray ends, kBelow or kAbove the tiles, or kUnsure.
  int place(int ray) const { return places_[static_cast<std::size_t>(ray)]; }

  /// Where in the cell to the right of a ray, in [0, 1], the one border lies that there is between two places, the
  /// wall's columns and rows being interpolated. Nothing if there are more, or if it is not sure whether the border's
  /// place, `width` being that of a cell, rounds to the same even number of pixels as the exact one.
  std::optional<double> border(int ray, double width) const;

  /// How far columns and rows may be wrong.
  double column_error() const { return camera_.column_error; }
  double row_error() const { return camera_.row_error; }
  double column(int ray) const { return columns_[static_cast<std::size_t>(ray)]; }
  double row(int ray) const { return rows_[static_cast<std::size_t>(ray)]; }

 private:
  using Numbers = std::array<float, kSketchedRays>;

  SketchingKernel* kernel_;  // null: none for this processor
  bool holds_ = false;       // the bounds, for the frame's camera
  SketchedCamera camera_;
  Numbers columns_{}, rows_{};
  Numbers column_floors_{};  // kUnsure where that is not sure
  Numbers row_floors_{};     // the same; from -1 (below) to the number of rows (above)
  std::array<int, kSketchedRays> places_{};
};

}  // namespace reorient

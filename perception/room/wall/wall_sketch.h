// SPDX-License-Identifier: MIT
// Positions where rays meet the wall, in single precision and with error bounds: a floating-point filter. Its certain
// results are the same as those of the exact computation, at a tenth of the time. For the rest, Wall::meet is used. It
// has versions for several processors; on other processors no result is certain.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "geometry/transform.h"
#include "perception/room/instructions.h"
#include "perception/room/wall/sketching_kernels.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// Number of cells between the rays of one band of the image.
inline constexpr int kBandCells = 40;

/// The rays of one band from left to right, scaled to (1, y, z) in the camera frame, with a cell between each two
/// neighbors.
class BandRays {
 public:
  /// Empty if there are not kBandCells + 1 rays, or if one points backward, or is too far off the axis for the error
  /// bounds.
  static std::optional<BandRays> of(std::span<const Eigen::Vector3d> rays);

  const float* y() const { return y_.data(); }
  const float* z() const { return z_.data(); }
  /// An upper bound of up(y, z) = from + y * by_y + z * by_z for these rays.
  float highest(float from, float by_y, float by_z) const;

 private:
  std::array<float, kSketchedRays> y_{}, z_{};  // padded with the last ray
  float y_least_ = 0.0f, y_most_ = 0.0f, z_least_ = 0.0f, z_most_ = 0.0f;
};

class WallSketch {
 public:
  /// Neither on a tile nor certainly off the wall.
  static constexpr int kUnsure = kNowhereSure;
  static constexpr int kBelow = kBelowTheTiles;
  static constexpr int kAbove = kAboveTheTiles;

  /// The processor must support `instructions`.
  explicit WallSketch(Instructions instructions = widest_instructions());

  /// Starts one frame.
  void prepare(const Wall& wall, const Isometry3& field_from_camera);
  /// Computes one band. False if the whole band is below the tiles, so that nothing of it is needed.
  bool draw(const BandRays& rays);
  /// Call it instead of draw() if no sketch is possible: then no result is certain.
  void leave_blank();

  /// The tile at the end of a ray, kBelow or kAbove the tiles, or kUnsure.
  int place(int ray) const { return places_[static_cast<std::size_t>(ray)]; }

  /// Position of the only border in the cell to the right of a ray, in [0, 1], with interpolated columns and rows of
  /// the wall. Empty if there are more borders, or if it is uncertain whether the position (times `width`, the width of
  /// a cell) rounds to the same even number of pixels as the exact one.
  std::optional<double> border(int ray, double width) const;

  /// Error bounds of columns and rows.
  double column_error() const { return camera_.column_error; }
  double row_error() const { return camera_.row_error; }
  double column(int ray) const { return columns_[static_cast<std::size_t>(ray)]; }
  double row(int ray) const { return rows_[static_cast<std::size_t>(ray)]; }

 private:
  using Numbers = std::array<float, kSketchedRays>;

  SketchingKernel* kernel_;  // null: no version for this processor
  bool holds_ = false;       // whether the bounds hold for the frame's camera
  SketchedCamera camera_;
  Numbers columns_{}, rows_{};
  Numbers column_floors_{};  // kUnsure if uncertain
  Numbers row_floors_{};     // the same; from -1 (below) to the number of rows (above)
  std::array<int, kSketchedRays> places_{};
};

}  // namespace reorient

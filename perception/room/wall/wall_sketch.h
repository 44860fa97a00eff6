// Where rays meet the wall, in single precision and with bounds of the error: a floating-point filter. What it is sure
// of is what exact computation finds, at a tenth of the time; for the rest there is Wall::meet.
#pragma once

#include <array>
#include <optional>

#include "geometry/transform.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// The rays of one band of the image, from the left to the right, with a cell between each two neighbours. Padded to
/// whole registers.
inline constexpr int kBandCells = 40;
using BandRays = std::array<float, 44>;

class WallSketch {
 public:
  /// Neither on a tile nor surely off the wall.
  static constexpr int kUnsure = -3;
  static constexpr int kBelow = -1;
  static constexpr int kAbove = -2;

  /// One frame.
  void prepare(const Wall& wall, const Isometry3& field_from_camera);
  /// One band of it. The rays' directions in the camera frame are (1, y, z). False if all of it is below the tiles:
  /// then there is nothing more to ask.
  bool draw(const BandRays& y, const BandRays& z);
  /// Instead: nothing is sure.
  void leave_blank();

  /// The tile on which a ray ends, kBelow or kAbove the tiles, or kUnsure.
  int place(int ray) const { return places_[static_cast<std::size_t>(ray)]; }

  /// Where in the cell to the right of a ray, in [0, 1], the one border lies that there is between two places, the
  /// wall's columns and rows being interpolated. Nothing if there are more, or if it is not sure whether the border's
  /// place, `width` being that of a cell, rounds to the same even number of pixels as the exact one.
  std::optional<double> border(int ray, double width) const;

  /// How far columns and rows may be wrong.
  double column_error() const { return column_error_; }
  double row_error() const { return row_error_; }
  double column(int ray) const { return columns_[static_cast<std::size_t>(ray)]; }
  double row(int ray) const { return rows_[static_cast<std::size_t>(ray)]; }

 private:
  bool holds_ = false;  // the bounds, for the frame's camera
  int wall_columns_ = 0;
  int wall_rows_ = 0;
  std::array<float, 9> rotation_{};  // row by row, after a turn that leads the camera's axis to the wall's azimuth 0
  std::array<float, 3> eye_{};       // the same; the height is above the lowest tiles
  float radius_ = 0.0f;
  float first_column_ = 0.0f;  // at the axis
  float row_height_ = 1.0f;
  float rows_per_metre_ = 1.0f;
  float column_error_ = 0.0f;
  float row_error_ = 0.0f;
  BandRays columns_{}, rows_{};
  BandRays column_floors_{};  // kUnsure where that is not sure
  BandRays row_floors_{};     // the same; from -1 (below) to the number of rows (above)
  std::array<int, std::tuple_size_v<BandRays>> places_{};
};

}  // namespace reorient

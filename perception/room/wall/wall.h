// SPDX-License-Identifier: MIT
// The virtual wall around the field: a cylinder of tiles (the paper's Section 3.2). Field frame.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "geometry/const_or.h"
#include "geometry/pose2.h"

namespace reorient {

/// Limit of the number of columns.
constexpr int kMostColumns = 128;

struct WallParameters {
  double radius = 8.0;
  double bottom = 0.7;
  double top = 5.5;
  int rows = 4;
  int columns = 48;
};
template <ConstOr<WallParameters> T, typename Visit>
void describe(T& p, Visit&& visit) {
  visit("radius", p.radius, 1.0, 200.0, "m", "radius of the virtual wall around the center of the field");
  visit("bottom", p.bottom, 0.0, 10.0, "m", "height of the lower edge of the lowest row of tiles");
  visit("top", p.top, 0.1, 120.0, "m", "height of the upper edge of the highest row of tiles");
  visit("rows", p.rows, 1, 8, "", "number of rows of tiles");
  visit("columns", p.columns, 4, kMostColumns, "",
        "number of columns of tiles around the field; an odd number is made even");
}
template <typename Visit, ConstOr<WallParameters> T>
void fields(Visit&& visit, T& p) {
  describe(p, [&](const char*, auto& value, const auto&...) { visit(value); });
}

/// A position on the wall in units of tiles: column in [0, columns), and row in [0, rows) on a tile.
struct WallPoint {
  double column = 0.0;
  double row = 0.0;
};

/// Column 0 begins at azimuth 0 (the +x axis, the opponent goal), and columns count to the left; row 0 is the lowest.
/// The number of a tile is row * columns + column. The reflection of a tile is half of the columns further.
class Wall {
 public:
  explicit Wall(const WallParameters& parameters = {});

  double radius() const { return radius_; }
  double bottom() const { return bottom_; }
  double top() const { return top_; }
  int rows() const { return rows_; }
  int columns() const { return columns_; }
  int tiles() const { return rows_ * columns_; }
  /// Parameters that make the same wall.
  WallParameters parameters() const { return {radius_, bottom_, top_, rows_, columns_}; }
  double column_width() const { return 2.0 * kPi / columns_; }    ///< rad
  double row_height() const { return (top_ - bottom_) / rows_; }  ///< m

  int tile(int row, int column) const { return row * columns_ + column; }
  int row_of(int tile) const { return tile / columns_; }
  int column_of(int tile) const { return tile % columns_; }
  int reflected(int tile) const;
  /// Exchanges the element of each tile with that of its reflection. Applying it twice is the identity. `of_tiles`: one
  /// element for each tile.
  template <typename T>
  void rotate_by_180_degrees(std::span<T> of_tiles) const {
    for (int tile = 0; tile < tiles(); ++tile) {
      if (const int other = reflected(tile); tile < other)
        std::swap(of_tiles[static_cast<std::size_t>(tile)], of_tiles[static_cast<std::size_t>(other)]);
    }
  }

  /// The fractional column at an azimuth in [-pi, pi] rad.
  double column_at(double azimuth) const;
  /// The point of the wall at a fractional column and row, m.
  Eigen::Vector3d point(double column, double row) const;
  Eigen::Vector3d center(int tile) const { return point(column_of(tile) + 0.5, row_of(tile) + 0.5); }
  /// Bottom left, bottom right, top right, top left, as seen from inside; m.
  std::array<Eigen::Vector3d, 4> corners(int tile) const;
  /// The outward normal: horizontal, of unit length.
  Eigen::Vector3d normal(int tile) const;

  bool surrounds(const Eigen::Vector2d& position) const;

  /// The position where a ray from a point inside meets the wall, which continues above and below the tiles. Empty for
  /// a vertical ray or a point outside.
  std::optional<WallPoint> meet(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const;
  /// The same for many rays from one point, in half of the time. As many positions as directions.
  void meet(const Eigen::Vector3d& from, std::span<const Eigen::Vector3d> directions,
            std::span<std::optional<WallPoint>> points) const;

  /// Azimuth of the wall where a horizontal ray meets it, rad in (-pi, pi]. Empty for a point outside.
  std::optional<double> azimuth_seen(const Eigen::Vector2d& from, double direction) const;
  /// The same for many unit vectors from a point inside, in less time. As many azimuths as vectors.
  void azimuths_seen(const Eigen::Vector2d& from, std::span<const Eigen::Vector2d> headings,
                     std::span<double> azimuths) const;

  bool operator==(const Wall&) const = default;

 private:
  Eigen::Vector2d direction(double column) const;

  double radius_;
  double bottom_;
  double top_;
  int rows_;
  int columns_;
  std::vector<Eigen::Vector2d> directions_;  // from the center to each half column, also beyond the last one
};

/// The azimuth of the wall at which the camera looks. Empty if it looks straight up or down, or is outside.
std::optional<double> view_center(const Wall& wall, const Pose2& belief, const Isometry3& robot_from_camera);

}  // namespace reorient

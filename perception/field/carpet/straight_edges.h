// SPDX-License-Identifier: MIT
// The straight edges of the carpet, on which most columns of the image agree.
#pragma once

#include <array>

#include <Eigen/Core>

#include "geometry/camera.h"
#include "perception/field/carpet/carpet_map.h"

namespace reorient {

/// The carpet is a convex polygon with few edges. An edge and the camera span a plane, whatever the lens.
class StraightEdges {
 public:
  using Rows = std::array<int, CarpetMap::kColumns>;

  /// `highest`: topmost row of carpet in each column, of the map; its number of rows: no carpet. No edges where no line
  /// explains enough of the columns.
  void find(const CarpetMap& map, const CameraModel& camera, const Rows& highest);

  /// Whether a pixel lies beyond one of the edges, by more than an edge may be uneven.
  bool is_beyond(const Eigen::Vector2d& pixel) const;

 private:
  struct Edge {
    Eigen::Vector3d down = Eigen::Vector3d::Zero();  ///< of unit length, across the plane, camera frame
    int score = 0;                                   ///< columns
  };

  Edge best_edge() const;
  int columns_lost_to(const Edge& edge) const;
  void remove_explained(const Edge& edge);

  CameraModel camera_;
  double tolerance_ = 0.0;                                    ///< rad
  Eigen::Matrix<double, 3, CarpetMap::kColumns> all_, open_;  ///< unit vectors to the topmost carpet, left to right
  int all_count_ = 0, open_count_ = 0;                        ///< open: not explained by an edge yet
  std::array<Edge, 3> edges_;
  std::size_t size_ = 0;
};

}  // namespace reorient

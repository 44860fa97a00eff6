// SPDX-License-Identifier: MIT
// The straight edges of the carpet that explain most columns of the image.
#pragma once

#include <array>

#include <Eigen/Core>

#include "geometry/camera.h"
#include "perception/field/carpet/carpet_map.h"

namespace reorient {

/// The carpet is a convex polygon with few edges. An edge and the camera span a plane for any lens.
class StraightEdges {
 public:
  using Rows = std::array<int, CarpetMap::kColumns>;

  /// `highest`: topmost row of carpet in each column of the map; its number of rows means no carpet. Finds no edges if
  /// no line explains enough columns.
  void find(const CarpetMap& map, const CameraModel& camera, const Rows& highest);

  /// Whether a pixel lies beyond one of the edges, by more than the tolerance.
  bool is_beyond(const Eigen::Vector2d& pixel) const;

 private:
  struct Edge {
    Eigen::Vector3d down = Eigen::Vector3d::Zero();  ///< unit normal of the plane, camera frame
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

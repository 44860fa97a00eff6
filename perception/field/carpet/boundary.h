// SPDX-License-Identifier: MIT
// The upper border of the carpet in the image.
#pragma once

#include <array>
#include <vector>

#include "geometry/camera.h"
#include "perception/field/carpet/carpet_map.h"
#include "perception/field/carpet/straight_edges.h"

namespace reorient {

/// One row (pixels) for each column of the map, as FieldPercept wants it: the image's height where no carpet is in
/// view. The field is convex, so a robot or a post in front of its border does not dent it. Its border is straight, so
/// what lies beyond the edges that most columns agree on does not belong to it, even in the carpet's color.
class Boundary {
 public:
  void find(const CarpetMap& map, const CameraModel& camera, std::vector<float>& boundary);

 private:
  int within_edges(const CarpetMap& map, int column, int row) const;

  StraightEdges edges_;
  StraightEdges::Rows highest_{};  ///< topmost row of carpet in each column; the map's rows: none
  StraightEdges::Rows smooth_{};
  std::array<int, CarpetMap::kColumns> hull_{};  ///< columns
};

/// Whether any of the rows is above the image's bottom.
bool shows_carpet(const std::vector<float>& boundary, int image_height);

/// The boundary at any column of an image of this width, between its own columns.
double boundary_at(const std::vector<float>& boundary, int width, double column);

}  // namespace reorient

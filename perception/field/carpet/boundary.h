// SPDX-License-Identifier: MIT
// The upper border of the carpet in the image.
#pragma once

#include <array>
#include <vector>

#include "geometry/camera.h"
#include "perception/field/carpet/carpet_map.h"
#include "perception/field/carpet/straight_edges.h"

namespace reorient {

/// One row (pixels) for each column of the map, in the format of FieldPercept: the image's height if no carpet is in
/// view. The field is convex, so a robot or a post in front of its border does not change it. The border is straight,
/// so everything beyond the edges that most columns agree on is outside, even with the carpet's color.
class Boundary {
 public:
  void find(const CarpetMap& map, const CameraModel& camera, std::vector<float>& boundary);

 private:
  int within_edges(const CarpetMap& map, int column, int row) const;

  StraightEdges edges_;
  StraightEdges::Rows
      highest_{};  ///< topmost row of carpet in each column; the map's number of rows if there is no carpet
  StraightEdges::Rows smooth_{};
  std::array<int, CarpetMap::kColumns> hull_{};  ///< columns
};

/// Whether any of the rows is above the image's bottom.
bool shows_carpet(const std::vector<float>& boundary, int image_height);

/// The boundary at any column of an image of this width, interpolated.
double boundary_at(const std::vector<float>& boundary, int width, double column);

}  // namespace reorient

// The upper border of the carpet in the image.
#pragma once

#include <array>
#include <vector>

#include "perception/field/carpet/carpet_map.h"

namespace reorient {

/// One row (pixels) for each column of the map, as FieldPercept wants it: the image's height where no carpet is in
/// view. The field is convex, so a robot or a post in front of its border does not dent it.
class Boundary {
 public:
  void find(const CarpetMap& map, int image_height, std::vector<float>& boundary);

 private:
  std::array<int, CarpetMap::kColumns> highest_{};  ///< topmost row of carpet in each column; the map's rows: none
  std::array<int, CarpetMap::kColumns> smooth_{};
  std::array<int, CarpetMap::kColumns> hull_{};  ///< columns
};

/// Whether any of the rows is above the image's bottom.
bool shows_carpet(const std::vector<float>& boundary, int image_height);

/// The boundary at any column of an image of this width, between its own columns.
double boundary_at(const std::vector<float>& boundary, int width, double column);

}  // namespace reorient

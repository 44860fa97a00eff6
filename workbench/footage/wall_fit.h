// SPDX-License-Identifier: MIT
// The virtual wall that suits a room which is no hall: as far away as what the images show, as high as they reach.
#pragma once

#include <optional>
#include <span>

#include "perception/room/wall/wall.h"
#include "robots/footage/footage.h"

namespace reorient {

/// What one image of a footage says about the wall: a small one of its luma, and where its camera was.
struct WallView {
  CameraModel camera;  ///< of the small image
  Isometry3 field_from_camera;
  std::vector<float> luma;  ///< row after row
};
/// Nothing where the pose is not known.
std::optional<WallView> wall_view(const FootageFrame& frame);

struct WallFit {
  double radius = 0.0;  ///< m
  double low = 0.0;     ///< m: with other pairs of images it lies between these in 90 % of cases
  double high = 0.0;
  int pairs = 0;  ///< of images that were compared
};

/// The median distance from the field's center of what the images show above the eye: for patches of one image, the
/// radius of the cylinder on which another one, taken elsewhere, shows the same (a plane sweep: Collins 1996). Nothing
/// where the images do not tell: taken from one place, too few, or of things that all are at other distances.
std::optional<WallFit> fit_wall(std::span<const WallView> views);

/// The wall of that radius which is as high as the images reach, with rows about as high as columns are wide.
WallParameters wall_of(double radius, std::span<const WallView> views, const WallParameters& usual);

}  // namespace reorient

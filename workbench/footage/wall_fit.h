// SPDX-License-Identifier: MIT
// Fits the virtual wall to the room of a footage: its distance and its height.
#pragma once

#include <optional>
#include <span>

#include "perception/room/wall/wall.h"
#include "robots/footage/footage.h"

namespace reorient {

/// One image of a footage for the fit: a small image of its luma, and the pose of its camera.
struct WallView {
  CameraModel camera;  ///< of the small image
  Isometry3 field_from_camera;
  std::vector<float> luma;  ///< row after row
};
/// Nothing if the pose is unknown.
std::optional<WallView> wall_view(const FootageFrame& frame);

struct WallFit {
  double radius = 0.0;  ///< m
  double low = 0.0;     ///< m: lower end of the 90 % interval over resampled pairs of images
  double high = 0.0;
  int pairs = 0;  ///< of images that were compared
};

/// The median distance of the visible room from the field's center, above the camera: for patches of one image, the
/// radius of the cylinder on which an image from another position shows the same (plane sweep: Collins 1996). Nothing
/// if the images do not determine it: from one position, too few, or inconsistent distances.
std::optional<WallFit> fit_wall(std::span<const WallView> views);

/// The wall of that radius, as high as the images reach, with rows about as high as columns are wide.
WallParameters wall_of(double radius, std::span<const WallView> views, const WallParameters& usual);

}  // namespace reorient

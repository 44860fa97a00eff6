// SPDX-License-Identifier: MIT
// Recolors an image as if taken with another camera, white balance or turf.
#pragma once

#include <string>
#include <vector>

#include "geometry/image.h"

namespace reorient {

/// In this order: the corners get darker, red and blue are multiplied, gamma; then, of chroma, the saturation and the
/// offset.
struct Recoloring {
  std::string name = {};      ///< for the user
  double vignetting = 0.0;    ///< fraction of the light that the corners lose
  double red = 1.0;           ///< factor
  double blue = 1.0;          ///< factor
  double gamma = 1.0;         ///< exponent of red, green and blue
  double saturation = 1.0;    ///< factor
  double cb = 0.0, cr = 0.0;  ///< offset
};

/// The recolorings on which the field vision is scored; the first changes nothing.
std::vector<Recoloring> usual_recolorings();

Image recolored(const ImageView& image, const Recoloring& how);

}  // namespace reorient

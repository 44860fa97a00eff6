// SPDX-License-Identifier: MIT
// The same image as another camera, another white balance or another turf would have shown it.
#pragma once

#include <string>
#include <vector>

#include "geometry/image.h"

namespace reorient {

/// In this order: the corners get darker, red and blue are multiplied, gamma; then, of chroma, the saturation and what
/// is added.
struct Recoloring {
  std::string name = {};      ///< for people
  double vignetting = 0.0;    ///< by how much of its light a corner gets darker
  double red = 1.0;           ///< times
  double blue = 1.0;          ///< times
  double gamma = 1.0;         ///< exponent of red, green and blue
  double saturation = 1.0;    ///< times
  double cb = 0.0, cr = 0.0;  ///< added
};

/// Those on which the field vision is judged, from none on.
std::vector<Recoloring> usual_recolorings();

Image recolored(const ImageView& image, const Recoloring& how);

}  // namespace reorient

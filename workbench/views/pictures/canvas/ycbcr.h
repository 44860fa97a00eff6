// SPDX-License-Identifier: MIT
// Converts the camera's colors to those of a screen.
#pragma once

#include "geometry/image.h"
#include "workbench/views/pictures/canvas/picture.h"

namespace reorient::pictures {

inline Color to_color(Ycbcr color) { return scene::to_color(color.y, color.cb, color.cr); }

Picture to_picture(const ImageView& image);

}  // namespace reorient::pictures

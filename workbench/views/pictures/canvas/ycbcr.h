// From the camera's colours to a screen's.
#pragma once

#include "geometry/image.h"
#include "workbench/views/pictures/canvas/picture.h"

namespace reorient::pictures {

/// Full-range BT.601, as JPEG has it.
Color to_color(Ycbcr color);

Picture to_picture(const ImageView& image);

}  // namespace reorient::pictures

// SPDX-License-Identifier: MIT
// The camera image with what the robot found in it and what it expected (the paper's Fig. 4b).
#pragma once

#include <string>

#include "geometry/image.h"
#include "workbench/views/pictures/canvas/picture.h"
#include "workbench/views/scene/shapes.h"

namespace reorient::pictures {

struct CameraView {
  ImageView image;
  double time = 0.0;  ///< s
  scene::Overlay overlay;
};

/// 1280 pixels wide, whatever the image's size, with the legend below the image. `caption`: in a line below the legend;
/// empty: the time beside it instead.
Picture draw_camera_view(const CameraView& camera, const std::string& caption = {});

/// The same without a legend, `width` pixels wide, with marks as small as the picture.
Picture draw_camera_thumbnail(const CameraView& camera, int width);

}  // namespace reorient::pictures

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

/// A picture 1280 pixels wide, independent of the image's size, with the legend below the image. `caption`: text below
/// the legend; empty: the time next to the legend instead.
Picture draw_camera_view(const CameraView& camera, const std::string& caption = {});

/// The same without a legend, `width` pixels wide, with marks scaled like the picture.
Picture draw_camera_thumbnail(const CameraView& camera, int width);

}  // namespace reorient::pictures

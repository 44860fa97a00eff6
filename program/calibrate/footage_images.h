// SPDX-License-Identifier: MIT
// The images of footage for the calibration of a camera, and the features in them.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/camera_offset.h"
#include "geometry/field_dimensions.h"
#include "localization/calibration/edge_offset.h"
#include "localization/calibration/line_offset.h"
#include "robots/footage/footage.h"

namespace reorient {

/// The images for a calibration, spread evenly over the footage.
std::vector<FootageFrame> images_for_calibration(FootageSource& source);

std::vector<EdgeView> edge_views(const std::vector<FootageFrame>& frames);

/// Images without a pose show no lines. `offset`: camera offset for the search of lines.
std::vector<LineView> line_views(const std::vector<FootageFrame>& frames, const CameraOffset& offset,
                                 const FieldDimensions& field);

/// Every second image: the odd ones for the fit, the even ones to check it.
template <typename View>
std::vector<View> every_second(const std::vector<View>& views, std::size_t first) {
  std::vector<View> half;
  for (std::size_t i = first; i < views.size(); i += 2) half.push_back(views[i]);
  return half;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
// The images of a footage from which a camera is calibrated, and what they show.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/camera_offset.h"
#include "geometry/field_dimensions.h"
#include "localization/calibration/edge_offset.h"
#include "localization/calibration/line_offset.h"
#include "robots/footage/footage.h"

namespace reorient {

/// Evenly over the whole footage, as many as a calibration needs.
std::vector<FootageFrame> images_for_calibration(FootageSource& source);

std::vector<EdgeView> edge_views(const std::vector<FootageFrame>& frames);

/// Images without a pose show no lines. `offset`: under which the lines are searched for.
std::vector<LineView> line_views(const std::vector<FootageFrame>& frames, const CameraOffset& offset,
                                 const FieldDimensions& field);

/// Every second one: the odd ones are for the fit, the even ones for its check.
template <typename View>
std::vector<View> every_second(const std::vector<View>& views, std::size_t first) {
  std::vector<View> half;
  for (std::size_t i = first; i < views.size(); i += 2) half.push_back(views[i]);
  return half;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Estimates a camera's offset (tilt, pan, roll and height) from field lines in many images from known poses.
#pragma once

#include <span>
#include <vector>

#include "geometry/camera.h"
#include "geometry/field_dimensions.h"
#include "geometry/pose2.h"
#include "geometry/transform.h"
#include "localization/calibration/offset_fit.h"
#include "perception/field/percepts.h"

namespace reorient {

/// The line points of one image.
struct LineView {
  CameraModel camera;
  Isometry3 robot_from_camera = Isometry3::Identity();  ///< as recorded
  Isometry3 found_from_camera = Isometry3::Identity();  ///< from which the line points were computed
  Pose2 robot;                                          ///< field_from_robot
  std::vector<LinePoint> line_points;
};

/// Determines nothing if too few points, or less than half of them, lie on lines.
OffsetEstimate offset_from_lines(std::span<const LineView> views, const FieldDimensions& field);

/// The angle at the camera between each point and the nearest line of its direction, rad, at most kMostLineAngle.
inline constexpr double kMostLineAngle = 0.05;
std::vector<WeightedResidual> line_angles(std::span<const LineView> views, const CameraOffset& offset,
                                          const FieldDimensions& field);

}  // namespace reorient

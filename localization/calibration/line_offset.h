// SPDX-License-Identifier: MIT
// A camera's offset from field lines that many images show from known poses: tilt, pan, roll and height.
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
  Isometry3 found_from_camera = Isometry3::Identity();  ///< with which the line points were found
  Pose2 robot;                                          ///< field_from_robot
  std::vector<LinePoint> line_points;
};

/// Nothing is determined where too few points lie on lines, or less than half of them.
OffsetEstimate offset_from_lines(std::span<const LineView> views, const FieldDimensions& field);

/// The angle at the camera between each point and the nearest line of about its direction, rad, at most kMostLineAngle.
inline constexpr double kMostLineAngle = 0.05;
std::vector<WeightedResidual> line_angles(std::span<const LineView> views, const CameraOffset& offset,
                                          const FieldDimensions& field);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Estimates the error of a camera's mounting from field lines in view of a robot at a known pose.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/camera.h"
#include "geometry/camera_offset.h"
#include "geometry/field_dimensions.h"
#include "geometry/pose2.h"
#include "geometry/transform.h"
#include "perception/field/percepts.h"

namespace reorient {

/// The lines of one image, computed with the nominal pose of the camera.
struct CalibrationView {
  CameraModel camera;
  Isometry3 robot_from_camera = Isometry3::Identity();
  std::vector<LinePoint> line_points;
};

struct CameraCorrection {
  CameraOffset offset;
  // Root mean square angle at the camera between the line points and their nearest lines, rad.
  double error_before = 0.0;
  double error_after = 0.0;
  int points = 0;  ///< on a line after the correction
};

/// `robot`: the robot's pose. Searches within 12 degrees of tilt and 8 degrees of pan. Empty if too few points or less
/// than half of them lie on lines, or if the lines have only one direction, which leaves one angle open.
std::optional<CameraCorrection> calibrate(std::span<const CalibrationView> views, const Pose2& robot,
                                          const FieldDimensions& field);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// By how much a camera looks elsewhere than it is believed to, from field lines that it sees at a known place.
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

/// What one image shows of lines, taken as if the camera looked where its data sheet says.
struct CalibrationView {
  CameraModel camera;
  Isometry3 robot_from_camera = Isometry3::Identity();
  std::vector<LinePoint> line_points;
};

struct CameraCorrection {
  CameraOffset offset;
  // The root mean square angle between what was seen and the nearest line, rad, as seen from the camera.
  double error_before = 0.0;
  double error_after = 0.0;
  int points = 0;  ///< that lie on a line afterwards
};

/// `robot`: where it stands. Nothing: too few points lie on lines, however the camera is turned (within 12 degrees of
/// tilt and 8 of pan), or less than half of all, or all of them on lines of one direction, which say nothing about the
/// other angle.
std::optional<CameraCorrection> calibrate(std::span<const CalibrationView> views, const Pose2& robot,
                                          const FieldDimensions& field);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// A robot at a known place looks about: what its cameras show of lines.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/field_dimensions.h"
#include "geometry/image.h"
#include "localization/calibration/camera_calibration.h"
#include "robots/robot.h"
#include "robots/robot_body.h"

namespace reorient {

/// Of one camera.
struct CalibrationShots {
  std::vector<CalibrationView> views;
  Image picture;  ///< the one with most lines, and which of the views it belongs to
  std::size_t pictured = 0;
};

/// Turns the head from place to place, and takes some images at each, as soon as it holds still there. Ends early where
/// the robot does, or where its head does not get anywhere.
std::array<CalibrationShots, 2> look_about(Robot& robot, const RobotBody& body, const FieldDimensions& field);

}  // namespace reorient

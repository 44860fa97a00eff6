// SPDX-License-Identifier: MIT
// A robot at a known pose turns its head: the lines that its cameras see.
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

/// The images of one camera.
struct CalibrationShots {
  std::vector<CalibrationView> views;
  Image picture;  ///< the image with most lines, and the index of its view
  std::size_t pictured = 0;
};

/// Turns the head to several directions, and takes some images at each as soon as the head is still. Ends early if the
/// robot ends, or if its head does not move.
std::array<CalibrationShots, 2> look_about(Robot& robot, const RobotBody& body, const FieldDimensions& field);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// The input of room awareness for one frame.
#pragma once

#include <optional>
#include <span>

#include "geometry/camera.h"
#include "geometry/image.h"
#include "geometry/pose2.h"

namespace reorient {

/// A part of the image that does not show the room: a robot, a goal. Pixels, all four sides inclusive.
struct CoveredArea {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

/// The input of room awareness for one frame.
struct RoomObservation {
  double time = 0.0;  ///< s
  ImageView image;
  CameraModel camera;
  Isometry3 robot_from_camera = Isometry3::Identity();
  Pose2 belief;  ///< believed pose, field_from_robot
  double odometry_rotation =
      0.0;  ///< rad, rotation to the left since the start, by dead reckoning; only its change is used
  std::span<const CoveredArea> covered;
  bool train = true;     ///< false: the background model is not updated
  bool evaluate = true;  ///< false: the view filter and the confidences are not updated
};

/// The observation's camera at its image's resolution. Empty if the image is missing, or if values of the camera or of
/// the poses are invalid.
std::optional<CameraModel> camera_of(const RoomObservation& view);

}  // namespace reorient

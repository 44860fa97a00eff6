// SPDX-License-Identifier: MIT
// What one frame tells room awareness.
#pragma once

#include <optional>
#include <span>

#include "geometry/camera.h"
#include "geometry/image.h"
#include "geometry/pose2.h"

namespace reorient {

/// A part of the image that does not show the room: a robot, a goal. Pixels, all four sides included.
struct CoveredArea {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

/// What one frame tells the module.
struct RoomObservation {
  double time = 0.0;  ///< s
  ImageView image;
  CameraModel camera;
  Isometry3 robot_from_camera = Isometry3::Identity();
  Pose2 belief;  ///< believed pose, field_from_robot
  double odometry_rotation =
      0.0;  ///< rad turned to the left since the start, by dead reckoning; only its change counts
  std::span<const CoveredArea> covered;
  bool train = true;     ///< false: the background model is left as it is
  bool evaluate = true;  ///< false: the view filter rests and the confidences stay as they are
};

/// The observation's camera at its image's resolution. Nothing where there is no image to speak of, or where numbers of
/// the camera or of the poses make no sense.
std::optional<CameraModel> camera_of(const RoomObservation& view);

}  // namespace reorient

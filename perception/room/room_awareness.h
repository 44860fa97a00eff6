// Room awareness (the paper's Section 3): from images and the believed pose to confidences in that pose and in its
// reflection. Pure: time and seed are arguments.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

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
struct RoomView {
  double time = 0.0;                                ///< s
  ImageView image;
  CameraModel camera;
  Eigen::Isometry3d robot_from_camera = Eigen::Isometry3d::Identity();
  Pose2 belief;                                     ///< believed pose, field_from_robot
  std::span<const CoveredArea> covered;
  bool train = true;                                ///< false: the background model is left as it is
  bool evaluate = true;                             ///< false: the view filter rests and the confidences stay as they are
};

/// All in [0, 1]; `current` and `opposite` are smoothed, their raw values are this frame's.
struct Confidences {
  double current = 0.0;
  double opposite = 0.0;
  double raw_current = 0.0;
  double raw_opposite = 0.0;
  double goal_opponent = 0.0;   ///< share of view particles on the wall behind the goal at +x
  double goal_own = 0.0;        ///< the same, behind the goal at -x
  double coverage = 0.0;        ///< share of the wall's tiles that are trained well enough to be compared with
  double informative = 0.0;     ///< how much the model differs from itself turned by 180 degrees: 0 is the same
  int visible_tiles = 0;        ///< tiles that counted in this frame
};

}  // namespace reorient

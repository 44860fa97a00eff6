// SPDX-License-Identifier: MIT
// Footage: images that another program recorded, with the known poses and camera of each. The readers of folders,
// videos and logs implement FootageSource (workbench/footage/). It drives the robot in robots/footage/footage_robot.h.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "geometry/camera.h"
#include "geometry/head.h"
#include "geometry/image.h"
#include "geometry/pose2.h"
#include "geometry/transform.h"

namespace reorient {

/// One image of footage. Poses are in the footage's own field frame: origin at the center, x toward one goal.
struct FootageFrame {
  double time = 0.0;   ///< s, as recorded, on any clock
  std::string name;    ///< for people: a file, or a number and a topic
  Image image;         ///< of even width
  CameraModel camera;  ///< at the image's resolution
  Isometry3 robot_from_camera = Isometry3::Identity();
  TorsoAttitude torso;            ///< upright if no inertial unit was recorded
  std::optional<Pose2> pose;      ///< field_from_robot, if it is known: m, rad
  std::optional<Pose2> odometry;  ///< dead reckoning from any start: m, rad
  std::optional<double> heading;  ///< rad, if only the rotation is known
};

/// The footage, or the rest of it, cannot be read. The message is one line: what was expected, what was found, where.
class BadFootage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class FootageSource {
 public:
  virtual ~FootageSource() = default;

  /// Reads the next frame; times increase from frame to frame. False: the end. Throws BadFootage if the rest cannot be
  /// read. The frames before remain valid, and each later call throws the same.
  virtual bool next(FootageFrame& frame) = 0;
};

}  // namespace reorient

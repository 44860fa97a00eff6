// SPDX-License-Identifier: MIT
// Footage: images that somebody else took, with what is known of each. Whoever reads a folder, a video or a log
// implements FootageSource (workbench/footage/); the robot that is driven by it is robots/footage/footage_robot.h.
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

/// One image of a footage. Poses are in the footage's own field frame: origin at the center, x towards one goal.
struct FootageFrame {
  double time = 0.0;   ///< s, as recorded, on any clock
  std::string name;    ///< for people: a file, or a number and a topic
  Image image;         ///< of even width
  CameraModel camera;  ///< at the image's resolution
  Isometry3 robot_from_camera = Isometry3::Identity();
  TorsoAttitude torso;            ///< where an inertial unit was recorded, else upright
  std::optional<Pose2> pose;      ///< field_from_robot, where it is known: m, rad
  std::optional<Pose2> odometry;  ///< dead reckoning since any start: m, rad
  std::optional<double> heading;  ///< rad, where the rotation alone is known
};

/// The footage cannot be read, or not any further: one line that says what was expected, what was found, and where.
class BadFootage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class FootageSource {
 public:
  virtual ~FootageSource() = default;

  /// Fills in the next frame; times increase from frame to frame. False: there is none any more. Throws BadFootage
  /// where the rest cannot be used; the frames before were good, and each later call throws the same.
  virtual bool next(FootageFrame& frame) = 0;
};

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Which tiles of the wall a robot sees that stands at one place and turns its head.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "geometry/head.h"
#include "geometry/image.h"
#include "geometry/pose2.h"
#include "perception/room/wall/perceived_tiles.h"
#include "robots/robot_body.h"

namespace reorient {

class VisibleTiles {
 public:
  /// `pose`: where the robot believes that it stands, field_from_robot, its torso upright.
  VisibleTiles(const RobotBody& body, const Wall& wall, const PerceptionParameters& parameters, const Pose2& pose);

  /// In the images of the upper camera, 160 pixels wide; the histograms are those of a black image. The head's angles
  /// are rounded to 0.03 rad, and each view is found only once.
  const std::vector<PerceivedTile>& at(const HeadAngles& head);

  const Pose2& pose() const { return pose_; }

 private:
  std::vector<PerceivedTile> find(const HeadAngles& head) const;

  RobotBody body_;
  Wall wall_;
  PerceptionParameters parameters_;
  Pose2 pose_;
  Image image_;
  std::map<std::pair<int, int>, std::vector<PerceivedTile>> views_;
};

}  // namespace reorient

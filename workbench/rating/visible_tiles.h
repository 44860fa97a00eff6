// SPDX-License-Identifier: MIT
// The tiles of the wall in view of a robot that stands at one position and rotates its head.
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
  /// `pose`: believed pose (field_from_robot) with an upright torso.
  VisibleTiles(const RobotBody& body, const Wall& wall, const PerceptionParameters& parameters, const Pose2& pose);

  /// In the images of the upper camera, 160 pixels wide; the histograms are those of a black image. The head's angles
  /// are rounded to 0.03 rad, and each view is computed only once.
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

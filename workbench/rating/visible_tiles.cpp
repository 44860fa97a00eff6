// SPDX-License-Identifier: MIT
#include "workbench/rating/visible_tiles.h"

#include <algorithm>
#include <cmath>

#include "perception/room/room_observation.h"

namespace reorient {
namespace {

constexpr double kGrain = 0.03;  // rad
constexpr int kWidth = 160;      // pixels

int height_of(const CameraOptics& camera) { return std::max(2, kWidth * camera.height / std::max(camera.width, 1)); }

}  // namespace

VisibleTiles::VisibleTiles(const RobotBody& body, const Wall& wall, const PerceptionParameters& parameters,
                           const Pose2& pose)
    : body_(body), wall_(wall), parameters_(parameters), pose_(pose), image_(kWidth, height_of(body.upper_camera)) {}

const std::vector<PerceivedTile>& VisibleTiles::at(const HeadAngles& head) {
  const std::pair<int, int> key(static_cast<int>(std::lround(head.yaw / kGrain)),
                                static_cast<int>(std::lround(head.pitch / kGrain)));
  const auto known = views_.find(key);
  if (known != views_.end()) return known->second;
  return views_.emplace(key, find({key.first * kGrain, key.second * kGrain})).first->second;
}

std::vector<PerceivedTile> VisibleTiles::find(const HeadAngles& head) const {
  RoomObservation view;
  view.image = image_.view();
  view.camera = camera_model(body_.upper_camera, image_.width(), image_.height());
  view.robot_from_camera = robot_from_camera(body_.dimensions, head, {}, body_.dimensions.torso_height);
  view.belief = pose_;
  PerceivedTiles tiles;
  tiles.find(view, wall_, parameters_);
  tiles.count(view.image, {}, {}, parameters_);
  std::vector<PerceivedTile> counting;
  std::copy_if(tiles.tiles().begin(), tiles.tiles().end(), std::back_inserter(counting),
               [](const PerceivedTile& tile) { return tile.counts; });
  return counting;
}

}  // namespace reorient

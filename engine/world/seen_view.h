// SPDX-License-Identifier: MIT
// The camera's direction from the room alone, which gives a lost pose filter a heading.
#pragma once

#include <algorithm>
#include <optional>

#include "localization/pose_belief.h"
#include "perception/room/room_awareness.h"

namespace reorient {

struct SeenViewParameters {
  double share = 0.6;
  double separability = 0.8;
  double deviation = 0.2;
};

template <typename Visit>
void describe(SeenViewParameters& p, Visit&& visit) {
  visit("share", p.share, 0.5, 1.0, "",
        "smallest fraction of the view filter's weight that must be near one direction of the wall");
  visit("separability", p.separability, 0.5, 1.0, "",
        "smallest probability that the room distinguishes a pose from its mirrored pose");
  visit("deviation", p.deviation, 0.01, 1.0, "rad",
        "smallest standard deviation of the view, since the robot may stand far from where it learned the room");
}

/// Of the last frame with a view of the room. `odometry_rotation`: current, rad. Nothing if the room is not decisive.
inline std::optional<SeenView> seen_view(const RoomAwareness& room, double odometry_rotation,
                                         const SeenViewParameters& parameters) {
  const auto clusters = room.view_filter().clusters();
  const std::optional<double> direction = room.last_direction();
  if (clusters.empty() || !direction || clusters.front().share < parameters.share) return std::nullopt;
  if (room.confidences().separability < parameters.separability) return std::nullopt;
  return SeenView{.azimuth = clusters.front().azimuth,
                  .deviation = std::max(clusters.front().spread, parameters.deviation),
                  .radius = room.wall().radius(),
                  .direction = angle_difference(*direction, odometry_rotation)};
}

}  // namespace reorient

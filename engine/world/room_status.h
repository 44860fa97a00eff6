// SPDX-License-Identifier: MIT
// Decides once for all behaviors whether the confidences can distinguish the believed from the mirrored pose, and the
// reason if not.
#pragma once

#include <string_view>

#include "engine/world/world.h"

namespace reorient {

struct RoomStatusParameters {
  double coverage = 0.3;
  double distinctiveness = 0.05;
  double separability = 0.5;
  double recovery_probability = 0.3;
  double age = 0.2;
};

template <typename Visit>
void describe(RoomStatusParameters& p, Visit&& visit) {
  visit("coverage", p.coverage, 0.0, 1.0, "", "smallest learned fraction of the wall at which the confidences count");
  visit("distinctiveness", p.distinctiveness, 0.0, 1.0, "",
        "smallest difference of the room from itself rotated by 180 degrees at which the confidences count");
  visit("separability", p.separability, 0.0, 1.0, "",
        "smallest probability that a rotation by 180 degrees changes the room; below it the room counts as symmetric");
  visit("recovery_probability", p.recovery_probability, 0.0, 1.0, "",
        "recovery probability above which the pose filter counts as lost: then both poses may be wrong");
  visit("age", p.age, 0.0, 60.0, "s",
        "shortest time with known tiles in view after a restart of the confidences before they count");
}

/// Returns the first reason that applies in the order of RoomStatus.
RoomStatus room_status(const World& world, const RoomStatusParameters& parameters);

/// Whether the room can distinguish the believed from the mirrored pose: learned, not symmetric, and evaluated.
/// Independent of whether it was seen for long enough (fresh), and of whether both poses are wrong
/// (lost).
bool can_tell(RoomStatus status);

}  // namespace reorient

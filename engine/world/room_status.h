// SPDX-License-Identifier: MIT
// May the room speak? Whether the confidences can tell the believed pose from its reflection, and if not, why not: said
// once, for every behaviour.
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
  visit("coverage", p.coverage, 0.0, 1.0, "", "share of the wall that must be learned before the room may speak");
  visit("distinctiveness", p.distinctiveness, 0.0, 1.0, "",
        "how much the room must differ from itself turned by half a turn");
  visit("separability", p.separability, 0.0, 1.0, "",
        "how probable it must be that half a turn changes the room, or the room is called symmetric");
  visit("recovery_probability", p.recovery_probability, 0.0, 1.0, "",
        "beyond this the pose filter counts as lost: then both poses may be wrong");
  visit("age", p.age, 0.0, 60.0, "s", "how long known tiles must have been in view since the confidences began anew");
}

/// The first reason in the order of RoomStatus.
RoomStatus room_status(const World& world, const RoomStatusParameters& parameters);

/// Whether the room can tell the believed pose from its reflection: it is known, not symmetric, and being compared.
/// Whether it has been seen for long enough is a different question (fresh), and so is whether both poses are wrong
/// (lost).
bool can_tell(RoomStatus status);

}  // namespace reorient

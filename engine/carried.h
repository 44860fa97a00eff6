// SPDX-License-Identifier: MIT
// State that one frame passes to the next.
#pragma once

#include <optional>

#include "engine/world/application_state.h"
#include "engine/world/external_belief.h"
#include "engine/world/world_tracker.h"
#include "geometry/pose2.h"

namespace reorient {

/// In addition, each module has its own memory: the filters, the room, the arbiter (whose last() contains the active
/// pauses), the machines. Until a stage replaces a value, it is that of the previous frame.
struct Carried {
  WorldTracker world;
  ApplicationState application{};
  std::optional<Pose2> odometry{};  ///< dead reckoning, as observed; nothing before the first frame
  bool get_up_requested = false;
  ExternalUse external{};
};

}  // namespace reorient

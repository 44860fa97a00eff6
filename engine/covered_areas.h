// SPDX-License-Identifier: MIT
// Which parts of an image do not show the room.
#pragma once

#include <vector>

#include "perception/field/percepts.h"
#include "perception/room/room_observation.h"

namespace reorient {

/// What stands on the field hides the room behind it: a tile counts only where it is really seen.
void collect_covered(const FieldPercept& percept, std::vector<CoveredArea>& covered);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// The parts of an image that do not show the room.
#pragma once

#include <vector>

#include "perception/field/percepts.h"
#include "perception/room/room_observation.h"

namespace reorient {

/// Objects on the field hide the room behind them: a tile counts only where it is visible.
void collect_covered(const FieldPercept& percept, std::vector<CoveredArea>& covered);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// The LEDs of a NAO show the engine's state to the operator.
#pragma once

#include "robots/answer.h"
#include "robots/nao/lola/command.h"

namespace reorient::nao {

/// Eyes: as much of each ring is green as the room speaks for the believed pose, and red as it speaks for its
/// reflection; dim blue: it cannot tell. Chest: green while the room is learned, white while that is paused.
Lights lights_of(const Answer& answer);

}  // namespace reorient::nao

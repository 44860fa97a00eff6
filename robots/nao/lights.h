// SPDX-License-Identifier: MIT
// The LEDs of a NAO show the engine's state to the operator.
#pragma once

#include "robots/answer.h"
#include "robots/nao/lola/command.h"

namespace reorient::nao {

/// Eyes: the green part of each ring is the probability of the believed pose, the red part that of the mirrored pose;
/// dim blue: the room gives no evidence. Chest: green during training, white while training is paused or the robot
/// does not stand, since the engine uses no images then. All dark without an answer: no frame was processed lately.
Lights lights_of(const Answer* answer, bool stands);

}  // namespace reorient::nao

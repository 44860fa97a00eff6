// Whether the room can tell a pose from its reflection at all: one that looks the same after half a turn cannot.
#pragma once

#include "perception/room/background_model.h"
#include "perception/room/view/viewpoint_scores.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// How much the model differs from itself turned by half a turn: the mean Hellinger distance over the tiles that are
/// trusted on both sides, in [0, 1]; 0 where there are none. The same scale in every mode and for every measure.
double distinctiveness(const BackgroundModel& model, const ComparedModel& compared, const Wall& wall);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// What a person reads of models of rooms.
#pragma once

#include <iosfwd>

#include "perception/room/model_comparison.h"
#include "perception/room/saved_model.h"

namespace reorient {

/// Wall, tiles that are known, and whether a robot can decide with it.
void print_model(const SavedModel& model, std::ostream& out);

/// Of two models with this wall: the means, whether one of them is turned, and where they differ most.
void print_comparison(const ModelComparison& comparison, const Wall& wall, std::ostream& out);

}  // namespace reorient

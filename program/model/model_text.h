// SPDX-License-Identifier: MIT
// Models of rooms as text for the user.
#pragma once

#include <iosfwd>

#include "perception/room/model_comparison.h"
#include "perception/room/saved_model.h"

namespace reorient {

/// Wall, known tiles, and whether the model is sufficient for decisions.
void print_model(const SavedModel& model, std::ostream& out);

/// Two models with this wall: mean difference, whether one is rotated by 180 degrees, and where they differ most.
void print_comparison(const ModelComparison& comparison, const Wall& wall, std::ostream& out);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// The pose particles just before and just after commands (the paper's Fig. 6).
#pragma once

#include <vector>

#include "geometry/field_dimensions.h"
#include "workbench/run/run_history.h"
#include "workbench/views/pictures/canvas/picture.h"

namespace reorient::pictures {

/// One row of two panels for each of the first ten commands.
Picture draw_reorientation_view(const FieldDimensions& field, const std::vector<ReorientationSnapshot>& reorientations);

}  // namespace reorient::pictures

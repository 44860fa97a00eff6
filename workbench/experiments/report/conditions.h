// SPDX-License-Identifier: MIT
// The part of a report that says what was run: the meaning of each axis, and the whole experiment.
#pragma once

#include "workbench/experiments/charts/markup.h"
#include "workbench/experiments/report/report.h"

namespace reorient {

void draw_conditions(Markup& out, const Report& report);

}  // namespace reorient

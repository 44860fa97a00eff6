// SPDX-License-Identifier: MIT
// The tables of a report.
#pragma once

#include "workbench/experiments/charts/markup.h"
#include "workbench/experiments/report/report.h"

namespace reorient {

/// A row for each cell.
void draw_rows(Markup& out, const Report& report);

/// A row for each cell and measure; writes nothing if the experiment has no measures.
void draw_measures(Markup& out, const Report& report);

/// Published results, with the rows of the same choices; writes nothing if the experiment has no references.
void draw_references(Markup& out, const Report& report);

/// Each series against the first, in pairs of equal seeds; writes nothing if no pair can be compared.
void draw_comparisons(Markup& out, const Report& report);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// The results of an experiment: a row for each cell, as text and as JSON.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "workbench/experiments/condition/condition.h"
#include "workbench/experiments/tables/cell_results.h"

namespace reorient {

/// A table as wide as its texts; below it, published measurements. If compasses were compared: compass_table.h instead,
/// also in JSON.
void print_rows(const Experiment& experiment, const std::vector<CellResults>& cells, std::ostream& out);

/// A list of rows: the axes' choices, the numbers, and a line for each trial (docs/experiments.md); then those that are
/// pooled over the rooms, without lines for their trials. Ends with a line break. Unknown values are null.
std::string rows_as_json(const Experiment& experiment, const std::vector<CellResults>& cells);

/// Throws std::runtime_error with one line if an axis has the name of one of a row's numbers, which would
/// hide it.
void check_axis_names(const Experiment& experiment);

}  // namespace reorient

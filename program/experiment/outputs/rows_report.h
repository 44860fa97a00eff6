// SPDX-License-Identifier: MIT
// What an experiment showed: a row for each cell, for a person and for programs.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "workbench/experiments/condition/condition.h"
#include "workbench/experiments/tables/cell_results.h"

namespace reorient {

/// A table as wide as its texts; below it, what others measured. Where compasses were compared: how well they tell a
/// pose from its reflection, instead (compass_table.h); so in JSON, too.
void print_rows(const Experiment& experiment, const std::vector<CellResults>& cells, std::ostream& out);

/// A list of rows: the axes' choices, the numbers, and a line for each trial (docs/experiments.md); then those that are
/// pooled over the rooms, without lines for their trials. Ends with a line break. What is not known is null.
std::string rows_as_json(const Experiment& experiment, const std::vector<CellResults>& cells);

/// Throws std::runtime_error with one line where an axis is called as one of a row's numbers, and would be hidden by
/// it.
void check_axis_names(const Experiment& experiment);

}  // namespace reorient

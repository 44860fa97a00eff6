// What an experiment showed: a row for each cell, for a person and for programs.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "workbench/experiments/condition/condition.h"
#include "workbench/experiments/tables/row.h"

namespace reorient {

struct CellRow {
  std::vector<std::string> choices;  ///< one for each axis
  Row row;
};

/// Throws std::runtime_error with one line where an axis is called as one of a row's numbers, and would be hidden by
/// it.
void check_axis_names(const Experiment& experiment);

/// A table as wide as its texts.
void print_rows(const Experiment& experiment, const std::vector<CellRow>& rows, std::ostream& out);

/// A list of rows: the axes' choices, then the numbers (docs/experiments.md); ends with a line break. What is not known
/// is null.
std::string rows_as_json(const Experiment& experiment, const std::vector<CellRow>& rows);

}  // namespace reorient

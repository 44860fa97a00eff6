// SPDX-License-Identifier: MIT
// All contents of a report, as plain data: the page, its figures and its files depend only on this.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "workbench/experiments/condition/condition.h"
#include "workbench/experiments/tables/cell_results.h"

namespace reorient {

/// Where the numbers come from; stands below each figure.
struct Provenance {
  std::string command;  ///< that makes the report again
  std::string version;
  std::string machine;  ///< processor and cores
  std::string when;
};

struct Report {
  Experiment experiment;
  std::vector<CellResults> cells;  ///< as cells_of(experiment), all with as many trials
  Provenance provenance;
  /// What runs one trial again, for a shell. Tasks are numbered as in the plan.
  std::function<std::string(int task)> command_of;
};

/// The number of a cell's trial in the plan.
int task_of(const Report& report, std::size_t cell, std::size_t trial);

/// "1 to 20": of the trials of each cell.
std::string seeds_of(const Report& report);

/// Until when a trial of this cell may come right, s.
double limit_of(const Report& report, std::size_t cell);

/// Choices of one axis are compared within a picture: the series. This is the last axis with several choices.
struct Series {
  std::string name;                ///< "default"; "all trials" where there are no axes
  std::string style;               ///< class of its color and dash
  std::vector<std::size_t> cells;  ///< all of this choice
};
std::vector<Series> series_of(const Report& report);

/// So many at a time as a picture can tell apart, each with a style of its own there: all of them, or the first, beside
/// which the others are to be seen, with some of the others in each.
std::vector<std::vector<Series>> pictures_of(const std::vector<Series>& series);

/// Cells that differ in nothing but their series.
struct CellGroup {
  std::string name;                ///< "room hall, test moving"; empty: there is but one
  std::vector<std::size_t> cells;  ///< in the order of the series
};
std::vector<CellGroup> groups_of(const Report& report);

/// The series that a cell belongs to.
const Series& series_of_cell(const std::vector<Series>& series, std::size_t cell);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// All contents of a report, as plain data: the page, its figures and its files depend only on this.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "workbench/experiments/condition/condition.h"
#include "workbench/experiments/tables/cell_results.h"

namespace reorient {

/// Provenance of the numbers, shown below each figure.
struct Provenance {
  std::string command;  ///< repeats the report
  std::string version;
  std::string machine;  ///< processor and cores
  std::string when;
};

struct Report {
  Experiment experiment;
  std::vector<CellResults> cells;  ///< as cells_of(experiment), all with as many trials
  Provenance provenance;
  /// The shell command that repeats one trial. Tasks are numbered as in the plan.
  std::function<std::string(int task)> command_of;
};

/// The number of a cell's trial in the plan.
int task_of(const Report& report, std::size_t cell, std::size_t trial);

/// "1 to 20": of the trials of each cell.
std::string seeds_of(const Report& report);

/// The time limit for a right belief in this cell, s.
double limit_of(const Report& report, std::size_t cell);

/// Choices of one axis are compared within a picture: the series. This is the last axis with several choices.
struct Series {
  std::string name;                ///< "default"; "all trials" without axes
  std::string style;               ///< class of its color and dash
  std::vector<std::size_t> cells;  ///< all of this choice
};
std::vector<Series> series_of(const Report& report);

/// Groups with as many series as a picture can distinguish, each with its own style: one group of all, or several
/// groups that each show the first series and some of the others.
std::vector<std::vector<Series>> pictures_of(const std::vector<Series>& series);

/// Cells that differ only in their series.
struct CellGroup {
  std::string name;                ///< "room hall, test moving"; empty: it is the only one
  std::vector<std::size_t> cells;  ///< in the order of the series
};
std::vector<CellGroup> groups_of(const Report& report);

/// The series that a cell belongs to.
const Series& series_of_cell(const std::vector<Series>& series, std::size_t cell);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// What an experiment on footage prints below its table of rows.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "program/footage/footage_trials.h"
#include "workbench/experiments/tables/cell_results.h"

namespace reorient {

/// All trials of an experiment. Each footage has a cell for each case, and each cell a trial for each start: the trial
/// with seed n is of start n - 1.
struct FootageResults {
  std::vector<std::string> names;  ///< of the footages
  std::vector<std::unique_ptr<FootageTrials>> footages;
  std::vector<FootageCase> cases;
  std::vector<CellResults> cells;

  std::size_t footage_of(std::size_t cell) const { return cell / cases.size(); }
  const FootageCase& case_of(std::size_t cell) const { return cases[cell % cases.size()]; }
};

/// The command that shows one trial of a footage, a start and a case.
using TrialCommand = std::function<std::string(std::size_t footage, std::size_t start, const FootageCase& one)>;

/// s, in the format of the command line.
double to_microseconds(double seconds);

/// Prints times in images, failed trials with reasons, limits of the figures, and the result in one line.
void print_footage_results(const FootageResults& results, const FootageTrialOptions& options,
                           const TrialCommand& command, std::ostream& out);

}  // namespace reorient

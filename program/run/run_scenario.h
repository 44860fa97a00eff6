// A run, from its options to its outputs.
#pragma once

#include <functional>
#include <iosfwd>
#include <vector>

#include "program/run/run_options.h"
#include "workbench/run/observer.h"
#include "workbench/run/run_summary.h"

namespace reorient {

/// What another one wants to see of a run, when it has seen enough, and what it says of it then.
struct RunGuests {
  std::vector<Observer*> observers;
  std::function<bool()> stop;                        ///< asked after each frame; may be empty
  std::function<void(RunSummary& summary)> verdict;  ///< instead of the scenario's; may be empty
};

/// Writes the timeline and the summary to `out`, progress and mistakes to `err`. Returns the exit code. Throws
/// std::runtime_error (of scripts: ScriptError) with one line on bad input.
int run_scenario(const RunOptions& options, const RunGuests& guests, std::ostream& out, std::ostream& err);

}  // namespace reorient

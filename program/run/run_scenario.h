// SPDX-License-Identifier: MIT
// A run, from its options to its outputs.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "geometry/field_dimensions.h"
#include "program/run/live_run.h"
#include "program/run/run_options.h"
#include "workbench/run/observer.h"
#include "workbench/run/run_summary.h"

namespace reorient {

/// Observers of the caller, its condition to end the run, and its verdict.
struct RunGuests {
  std::vector<Observer*> observers;
  std::function<bool()> stop;                        ///< called after each frame; may be empty
  std::function<void(RunSummary& summary)> verdict;  ///< instead of the scenario's; may be empty
};

/// A robot and an engine that are ready to run, on a simulated clock. The objects that it points to must outlive the
/// run.
struct PreparedRun {
  LiveRunParts live;                       ///< without observers and a recording
  std::string venue;                       ///< room and field, for the user
  ConsoleSubject subject;                  ///< the objects that commands change
  FieldDimensions field;                   ///< limits the poses that the operator sets
  std::function<std::string()> failure{};  ///< one line, once it is over: why the robot ended early; may be empty
};

/// Runs, and writes the outputs that the options request. An Interruption must exist. Returns the exit code.
int run_prepared(const RunOptions& options, PreparedRun run, const RunGuests& guests, std::ostream& out,
                 std::ostream& err);

/// Writes the timeline and the summary to `out`, progress and errors to `err`. Returns the exit code. Throws
/// std::runtime_error (of scripts: ScriptError) with one line on bad input.
int run_scenario(const RunOptions& options, const RunGuests& guests, std::ostream& out, std::ostream& err);

}  // namespace reorient

// `reorient run`: a scenario on the simulator, its timeline, its summary and its pictures.
#pragma once

#include <iosfwd>

#include "engine/program/run_options.h"

namespace reorient {

/// Returns the exit code. Throws std::runtime_error with one line on bad input, before anything runs.
int run_scenario(const RunOptions& options, std::ostream& out, std::ostream& err);

}  // namespace reorient

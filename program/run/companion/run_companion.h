// SPDX-License-Identifier: MIT
// `reorient run --robot companion`: the engine beside a team's own program, until it is stopped.
#pragma once

#include <iosfwd>

#include "program/run/run_options.h"

namespace reorient {

/// The exit code. Throws std::runtime_error (of a script: ScriptError) with one line on bad input.
int run_companion(const RunOptions& options, std::ostream& out, std::ostream& err);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// `reorient run --robot nao`: the engine alone on a NAO, until it is stopped.
#pragma once

#include <iosfwd>

#include "program/run/run_options.h"

namespace reorient {

/// The exit code. Throws std::runtime_error (of a script: ScriptError) with one line on bad input.
int run_nao(const RunOptions& options, std::ostream& out, std::ostream& err);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// `reorient run --robot footage SOURCE`: the engine processes recorded images.
#pragma once

#include <iosfwd>

#include "program/run/run_options.h"

namespace reorient {

/// The exit code. Throws std::runtime_error (of a script: ScriptError) with one line on bad input.
int run_footage(const RunOptions& options, std::ostream& out, std::ostream& err);

}  // namespace reorient

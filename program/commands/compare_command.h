// SPDX-License-Identifier: MIT
// `reorient experiment compare`: compares two runs of an experiment, or two choices of one run.
#pragma once

#include "program/subcommand.h"

namespace reorient {

/// `experiment`: the parser of `reorient experiment`.
Subcommand add_compare(CLI::App& experiment);

}  // namespace reorient

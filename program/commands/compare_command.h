// SPDX-License-Identifier: MIT
// `reorient experiment compare`: what changed between two runs of an experiment, or from one choice to another.
#pragma once

#include "program/subcommand.h"

namespace reorient {

/// `experiment`: the parser of the word before it.
Subcommand add_compare(CLI::App& experiment);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// `reorient experiment footage`: would room awareness have helped this robot? Many trials on what somebody recorded.
#pragma once

#include "program/subcommand.h"

namespace reorient {

/// `experiment`: the parser of the word before it.
Subcommand add_footage_experiment(CLI::App& experiment);

}  // namespace reorient

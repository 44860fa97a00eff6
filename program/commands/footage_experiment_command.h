// SPDX-License-Identifier: MIT
// `reorient experiment footage`: many trials on recorded images, which show whether room awareness helps this robot.
#pragma once

#include "program/subcommand.h"

namespace reorient {

/// `experiment`: the parser of `reorient experiment`.
Subcommand add_footage_experiment(CLI::App& experiment);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// `reorient experiment field_features`: what the field vision finds in images of the simulator, by its labels.
#pragma once

#include "program/subcommand.h"

namespace reorient {

/// `experiment`: the parser of the word before it.
Subcommand add_field_features_experiment(CLI::App& experiment);

}  // namespace reorient

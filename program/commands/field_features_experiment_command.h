// SPDX-License-Identifier: MIT
// `reorient experiment field_features`: scores the field vision on images of the simulator, by their labels.
#pragma once

#include "program/subcommand.h"

namespace reorient {

/// `experiment`: the parser of `reorient experiment`.
Subcommand add_field_features_experiment(CLI::App& experiment);

}  // namespace reorient

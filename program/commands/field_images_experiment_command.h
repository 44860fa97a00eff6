// SPDX-License-Identifier: MIT
// `reorient experiment field_images`: scores the field vision on labeled images of real fields.
#pragma once

#include "program/subcommand.h"

namespace reorient {

/// `experiment`: the parser of `reorient experiment`.
Subcommand add_field_images_experiment(CLI::App& experiment);

}  // namespace reorient

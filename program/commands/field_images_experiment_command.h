// SPDX-License-Identifier: MIT
// `reorient experiment field_images`: the field vision on labeled images of real fields.
#pragma once

#include "program/subcommand.h"

namespace reorient {

/// `experiment`: the parser of the word before it.
Subcommand add_field_images_experiment(CLI::App& experiment);

}  // namespace reorient

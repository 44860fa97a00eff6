// SPDX-License-Identifier: MIT
// `reorient experiment tables`: updates the tables of a page from the results that it names.
#pragma once

#include "program/subcommand.h"

namespace reorient {

/// `experiment`: the parser of `reorient experiment`.
Subcommand add_tables(CLI::App& experiment);

}  // namespace reorient

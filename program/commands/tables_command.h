// SPDX-License-Identifier: MIT
// `reorient experiment tables`: generates the tables of pages from the results that they name.
#pragma once

#include "program/subcommand.h"

namespace reorient {

/// `experiment`: the parser of the word before it.
Subcommand add_tables(CLI::App& experiment);

}  // namespace reorient

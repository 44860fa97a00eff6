// SPDX-License-Identifier: MIT
// `reorient experiment tables`: the tables of a page, made anew from the results that it names.
#pragma once

#include "program/subcommand.h"

namespace reorient {

/// `experiment`: the parser of the word before it.
Subcommand add_tables(CLI::App& experiment);

}  // namespace reorient

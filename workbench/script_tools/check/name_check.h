// Finds slips in the names of a script without running it: unknown globals, fields, params and states, calls with the
// wrong arguments, commands in conditions, writing to what is read-only.
#pragma once

#include <string_view>
#include <vector>

#include "engine/script/machine/machine_definition.h"
#include "workbench/script_tools/check/symbol_table.h"

namespace reorient {

/// `text` must be valid Lua. In the order of the text. Follows `local` names as far as they stand for one thing: a
/// table of the world, a `param` table, a module; what it cannot follow it believes.
std::vector<DeclarationError> check_names(std::string_view text, const SymbolTable& known);

}  // namespace reorient

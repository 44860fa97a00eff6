// SPDX-License-Identifier: MIT
// Finds mistakes in the text of a script without running it: unknown names, values of a wrong type, calls with wrong
// arguments, commands in conditions, writing to read-only values.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/script_tools/check/finding.h"
#include "workbench/script_tools/check/symbol_table.h"

namespace reorient {

struct TextCheck {
  std::vector<Finding> findings;  ///< without their file, in the order of the text
  /// Signatures of the functions in the table that the script returns, if it returns one.
  std::map<std::string, FunctionSymbol> functions;
};

/// `text` must be valid Lua. Follows values whose type the text determines: the world, a `param` or `keep` table, a
/// module, the script's own tables and functions. Values that it cannot follow are accepted.
TextCheck check_text(std::string_view text, const SymbolTable& known);

}  // namespace reorient

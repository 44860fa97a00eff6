// SPDX-License-Identifier: MIT
// Finds slips in the text of a script without running it: names that do not exist, values of a wrong type, calls with
// wrong arguments, commands in conditions, writing to what is read-only.
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
  /// What is known of the functions in the table that the script returns, where it returns one.
  std::map<std::string, FunctionSymbol> functions;
};

/// `text` must be valid Lua. Follows values as far as the text says plainly what they are: the world, a `param` or
/// `keep` table, a module, the script's own tables and functions; what it cannot follow it believes.
TextCheck check_text(std::string_view text, const SymbolTable& known);

}  // namespace reorient

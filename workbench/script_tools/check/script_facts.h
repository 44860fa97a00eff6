// SPDX-License-Identifier: MIT
// Types of a script's own tables, functions and variables, from its text.
#pragma once

#include <map>
#include <set>
#include <string>

#include "workbench/script_tools/check/symbol_table.h"
#include "workbench/script_tools/syntax/lua_syntax.h"

namespace reorient {

/// A field of a table of the script, with all values that the script writes to it.
struct FieldFacts {
  ValueTypes types = 0;
  int writes = 0;
  bool is_declared = false;  ///< the constructor writes it
  bool is_read = false;
  const LuaToken* place = nullptr;             ///< first position at which it is written
  const syntax::Function* function = nullptr;  ///< the last function that was written to it
};

struct TableFacts {
  std::map<std::string, FieldFacts> fields;
  bool is_open = false;    ///< passed to code that may write to it, or written with a computed key
  bool is_walked = false;  ///< read with a computed key, or as a whole
};

/// The keys are the declaring token of a local, the constructor of a table, and the function.
struct ScriptFacts {
  std::map<const LuaToken*, ValueTypes> assigned;  ///< types of locals that are assigned several times
  std::map<const syntax::Expression*, TableFacts> tables;
  std::map<const syntax::Function*, FunctionSymbol> functions;
  const syntax::Expression* returned = nullptr;  ///< the table that the script returns to `require`
};

}  // namespace reorient

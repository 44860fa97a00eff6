// SPDX-License-Identifier: MIT
// Types of a script's own tables, functions and variables, from its text.
#pragma once

#include <map>
#include <set>
#include <string>

#include "workbench/script_tools/check/symbol_table.h"
#include "workbench/script_tools/syntax/lua_syntax.h"

namespace reorient {

/// A field of a table of the script: all values that are written to it anywhere.
struct FieldFacts {
  ValueTypes types = 0;
  int writes = 0;
  bool is_declared = false;  ///< the constructor writes it
  bool is_read = false;
  const LuaToken* place = nullptr;             ///< where it is written first
  const syntax::Function* function = nullptr;  ///< the last one that was written
};

struct TableFacts {
  std::map<std::string, FieldFacts> fields;
  bool is_open = false;    ///< passed to code that may write to it, or written with computed keys
  bool is_walked = false;  ///< read by computed keys, or as a whole
};

/// Locals are named by the token that declares them, tables by their constructors.
struct ScriptFacts {
  std::map<const LuaToken*, ValueTypes> assigned;  ///< locals that are written again, with all that they may be
  std::map<const syntax::Expression*, TableFacts> tables;
  std::map<const syntax::Function*, FunctionSymbol> functions;
  const syntax::Expression* returned = nullptr;  ///< the table that the script gives to who requires it
};

}  // namespace reorient

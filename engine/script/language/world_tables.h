// SPDX-License-Identifier: MIT
// The world in one script's Lua: read-only tables that are refreshed each frame and refuse names that do not exist.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <lua.hpp>

#include "engine/script/language/script_language.h"

namespace reorient {

class WorldTables {
 public:
  /// Makes the tables of a language as globals of `L`. The fields must outlive them.
  WorldTables(lua_State* L, const ScriptLanguage& language);

  /// Writes the values that changed since the last call; `values` in the order of the language's fields, NaN: unknown.
  void refresh(std::span<const double> values);

 private:
  struct Shown {
    const WorldField* field = nullptr;
    int table = 0;  ///< of the values, in the registry
    double value = 0.0;
  };

  lua_State* lua_;
  std::vector<Shown> shown_;
};

/// Makes the table on top of the stack read-only: an empty table replaces it and gives access to its fields.
/// `what` names it in errors ("robot"). An unknown field is an error, with "did you mean".
/// `language`: if the table is one of its world; must outlive it.
void make_read_only(lua_State* L, const std::string& what, const ScriptLanguage* language = nullptr);
/// The same for a list, in which a missing element is nil.
void make_read_only_list(lua_State* L, const std::string& what);

}  // namespace reorient

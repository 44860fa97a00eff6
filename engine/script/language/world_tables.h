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

  /// Writes what changed since the last call; `values` in the order of the language's fields, NaN: not known.
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

/// Makes the table on top of the stack read-only: it is replaced by an empty table through which its fields are seen.
/// `what` names it in errors ("robot"). A field that is not there is an error, with "did you mean".
/// `language`: where the table is one of its world, which must outlive it.
void make_read_only(lua_State* L, const std::string& what, const ScriptLanguage* language = nullptr);

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "engine/script/language/script_language.h"

#include <map>

#include "engine/script/language/world_tables.h"

namespace reorient {

std::string_view to_string(ScriptKind kind) { return kind == ScriptKind::behavior ? "behavior" : "scenario"; }

void add_script_functions(lua_State* L, ScriptLanguage& language) {
  std::map<std::string, std::vector<const ScriptFunction*>> tables;
  for (const ScriptFunction& function : language.functions()) tables[function.table].push_back(&function);
  for (const auto& [table, functions] : tables) {
    lua_newtable(L);
    for (const ScriptFunction* function : functions) {
      lua_pushlightuserdata(L, function->object(language.actions()));
      lua_pushcclosure(L, function->call, 1);
      if (table.empty()) {
        lua_setglobal(L, function->name.c_str());
      } else {
        lua_setfield(L, -2, function->name.c_str());
      }
    }
    if (table.empty()) {
      lua_pop(L, 1);
    } else {
      make_read_only(L, table);
      lua_setglobal(L, table.c_str());
    }
  }
  for (const FormerTable& former : language.former_tables()) {
    lua_getglobal(L, former.replacement.data());
    lua_setglobal(L, former.name.data());
  }
}

}  // namespace reorient

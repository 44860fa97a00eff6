// SPDX-License-Identifier: MIT
#include "engine/script/language/world_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>

#include "engine/parameters/nearest_name.h"

namespace reorient {
namespace {

/// The string keys of the table at `index`.
std::vector<std::string> keys_of(lua_State* L, int index) {
  std::vector<std::string> keys;
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) == LUA_TSTRING) keys.emplace_back(lua_tostring(L, -2));
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

/// Upvalues: the table's name; the language, if it is a table of the world. Arguments: the table of values, an unknown
/// key.
int refuse_unknown(lua_State* L) {
  const std::string table = lua_tostring(L, lua_upvalueindex(1));
  if (lua_type(L, 2) != LUA_TSTRING) {
    return luaL_error(L, "%s: expected the name of a field, found a %s", table.c_str(), luaL_typename(L, 2));
  }
  const std::string key = lua_tostring(L, 2);
  if (const auto* language = static_cast<const ScriptLanguage*>(lua_touserdata(L, lua_upvalueindex(2)))) {
    for (const WorldField& field : language->world()) {
      if (field.table != table || field.name != key) continue;
      return luaL_error(L, "%s.%s has no value: this robot does not measure it, or the script is still being loaded",
                        table.c_str(), key.c_str());
    }
  }
  const std::string hint = did_you_mean(key, keys_of(L, 1));
  return luaL_error(L, "%s has no field '%s'%s", table.c_str(), key.c_str(), hint.c_str());
}

int refuse_writing(lua_State* L) { return luaL_error(L, "%s is read-only", lua_tostring(L, lua_upvalueindex(1))); }

/// Upvalue: the table of values. `pairs` over a read-only table iterates over the values.
int pairs_of_values(lua_State* L) {
  lua_getglobal(L, "pairs");
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_call(L, 1, 3);
  return 3;
}

int length_of_values(lua_State* L) {
  lua_pushinteger(L, static_cast<lua_Integer>(lua_rawlen(L, lua_upvalueindex(1))));
  return 1;
}

void add_unknown_name_error(lua_State* L, const std::string& what, const ScriptLanguage* language) {
  lua_createtable(L, 0, 1);
  lua_pushlstring(L, what.data(), what.size());
  // Lua has no pointer to const; the language is only read through it.
  lua_pushlightuserdata(L, const_cast<ScriptLanguage*>(language));
  lua_pushcclosure(L, refuse_unknown, 2);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
}

}  // namespace

void make_read_only(lua_State* L, const std::string& what, const ScriptLanguage* language) {
  add_unknown_name_error(L, what, language);
  make_read_only_list(L, what);
}

void make_read_only_list(lua_State* L, const std::string& what) {
  lua_newtable(L);           // the proxy that the script gets
  lua_createtable(L, 0, 5);  // its metatable
  lua_pushvalue(L, -3);
  lua_setfield(L, -2, "__index");
  lua_pushlstring(L, what.data(), what.size());
  lua_pushcclosure(L, refuse_writing, 1);
  lua_setfield(L, -2, "__newindex");
  lua_pushvalue(L, -3);
  lua_pushcclosure(L, pairs_of_values, 1);
  lua_setfield(L, -2, "__pairs");
  lua_pushvalue(L, -3);
  lua_pushcclosure(L, length_of_values, 1);
  lua_setfield(L, -2, "__len");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
  lua_remove(L, -2);
}

WorldTables::WorldTables(lua_State* L, const ScriptLanguage& language) : lua_(L) {
  std::map<std::string_view, int> tables;
  for (const WorldTable& table : language.tables()) {
    lua_newtable(L);
    lua_pushvalue(L, -1);
    tables[table.name] = luaL_ref(L, LUA_REGISTRYINDEX);
    make_read_only(L, std::string(table.name), &language);
    lua_setglobal(L, table.name.data());
  }
  for (const WorldField& field : language.world())
    shown_.push_back({&field, tables.at(field.table), std::numeric_limits<double>::quiet_NaN()});
}

void WorldTables::refresh(std::span<const double> values) {
  int table = LUA_NOREF;
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    Shown& shown = shown_[i];
    const double value = values[i];
    const bool unknown = std::isnan(value);
    if (value == shown.value || (unknown && std::isnan(shown.value))) continue;
    shown.value = value;
    if (table != shown.table) {
      if (table != LUA_NOREF) lua_pop(lua_, 1);
      table = shown.table;
      lua_rawgeti(lua_, LUA_REGISTRYINDEX, table);
    }
    lua_pushlstring(lua_, shown.field->name.data(), shown.field->name.size());
    if (unknown) {
      lua_pushnil(lua_);
    } else if (shown.field->type == WorldField::Type::boolean) {
      lua_pushboolean(lua_, value != 0.0 ? 1 : 0);
    } else if (shown.field->type == WorldField::Type::name) {
      const std::string_view name = shown.field->names[static_cast<std::size_t>(value)];
      lua_pushlstring(lua_, name.data(), name.size());
    } else {
      lua_pushnumber(lua_, value);
    }
    lua_rawset(lua_, -3);
  }
  if (table != LUA_NOREF) lua_pop(lua_, 1);
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "engine/script/language/behavior_view.h"

#include "engine/script/sandbox/sandbox.h"

namespace reorient {
namespace {

constexpr std::int64_t kPriceOfSearch = 20;

const MachineDirectory& directory_of(lua_State* L) {
  return *static_cast<const MachineDirectory*>(lua_touserdata(L, lua_upvalueindex(1)));
}

int refuse_setting(lua_State* L) {
  return luaL_error(L, "behaviors is read-only: a script cannot set a behavior's state");
}

/// Upvalues: the directory, the machine's name. Arguments: its table, a key. A behavior that does not run has no state
/// and was in it for 0 s, so that a script may depend on behaviors that some runs leave out.
int read_field(lua_State* L) {
  Sandbox::of(L).charge(kPriceOfSearch);
  const std::string_view key = luaL_checkstring(L, 2);
  MachineSight sight;
  const bool runs = directory_of(L).look_up(lua_tostring(L, lua_upvalueindex(2)), sight);
  if (key == "state" && !runs) {
    lua_pushnil(L);
  } else if (key == "state") {
    lua_pushlstring(L, sight.state.data(), sight.state.size());
  } else if (key == "time_in_state") {
    lua_pushnumber(L, sight.time_in_state);
  } else {
    return luaL_error(L, "behaviors: unknown field '%s' (expected 'state' or 'time_in_state')", key.data());
  }
  return 1;
}

void set_reader(lua_State* L, lua_CFunction refuse) {
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, refuse);
  lua_setfield(L, -2, "__newindex");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
}

/// Upvalues: the directory, the tables made so far. Arguments: `behaviors`, a name.
int find_machine(lua_State* L) {
  Sandbox::of(L).charge(kPriceOfSearch);
  const char* const name = luaL_checkstring(L, 2);
  if (lua_getfield(L, lua_upvalueindex(2), name) == LUA_TTABLE) return 1;
  lua_newtable(L);
  lua_createtable(L, 0, 3);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_pushvalue(L, 2);
  lua_pushcclosure(L, read_field, 2);
  set_reader(L, refuse_setting);
  lua_pushvalue(L, -1);
  lua_setfield(L, lua_upvalueindex(2), name);
  return 1;
}

int refuse_publishing(lua_State* L) { return luaL_error(L, "published is read-only: declare `publishes` in a state"); }

/// Upvalue: the directory. Arguments: `published`, a name. A name that no loaded script publishes is false.
int read_published(lua_State* L) {
  Sandbox::of(L).charge(kPriceOfSearch);
  std::size_t length = 0;
  const char* const flag = luaL_checklstring(L, 2, &length);
  lua_pushboolean(L, directory_of(L).is_published({flag, length}) ? 1 : 0);
  return 1;
}

}  // namespace

void add_behavior_view(lua_State* L, const MachineDirectory& directory) {
  lua_newtable(L);
  lua_createtable(L, 0, 3);
  // Lua has no pointer to const; the directory is only read through it.
  lua_pushlightuserdata(L, const_cast<MachineDirectory*>(&directory));
  lua_newtable(L);
  lua_pushcclosure(L, find_machine, 2);
  set_reader(L, refuse_setting);
  lua_setglobal(L, "behaviors");

  lua_newtable(L);
  lua_createtable(L, 0, 3);
  lua_pushlightuserdata(L, const_cast<MachineDirectory*>(&directory));
  lua_pushcclosure(L, read_published, 1);
  set_reader(L, refuse_publishing);
  lua_setglobal(L, "published");
}

}  // namespace reorient

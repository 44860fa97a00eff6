// SPDX-License-Identifier: MIT
#include "engine/script/language/called_view.h"

#include "engine/script/sandbox/sandbox.h"

namespace reorient {
namespace {

constexpr std::int64_t kPriceOfCalled = 20;

// Upvalues of every function of this file.
constexpr int kDirectory = 1;
constexpr int kActions = 2;
constexpr int kBehavior = 3;
constexpr int kAwaitedEnd = 4;

template <typename T>
const T& object_at(lua_State* L, int upvalue) {
  return *static_cast<const T*>(lua_touserdata(L, lua_upvalueindex(upvalue)));
}

/// Pushes both objects, as the first upvalues.
void push_objects(lua_State* L) {
  lua_pushvalue(L, lua_upvalueindex(kDirectory));
  lua_pushvalue(L, lua_upvalueindex(kActions));
}

CalledSight sight_of(lua_State* L, const char* behavior) {
  Sandbox::of(L).charge(kPriceOfCalled);
  const Machine* const caller = object_at<ScriptActions>(L, kActions).running();
  if (caller == nullptr) luaL_error(L, "called: no behavior runs while a script is loaded");
  CalledSight sight;
  if (object_at<MachineDirectory>(L, kDirectory).look_up_called(*caller, behavior, sight)) return sight;
  luaL_error(L, "called: '%s' does not run '%s'", caller->definition().name.c_str(), behavior);
  return sight;
}

void push_text(lua_State* L, std::string_view text) { lua_pushlstring(L, text.data(), text.size()); }

/// Arguments: the table of a behavior, a key. A behavior that does not run now has no state, and an outcome only if it
/// has ended.
int read_called(lua_State* L) {
  const std::string_view key = luaL_checkstring(L, 2);
  const CalledSight sight = sight_of(L, lua_tostring(L, lua_upvalueindex(kBehavior)));
  if (key == "time_in_state") {
    lua_pushnumber(L, sight.time_in_state);
  } else if (key != "outcome" && key != "reason" && key != "state") {
    return luaL_error(L, "called: unknown field '%s' (expected 'outcome', 'reason', 'state' or 'time_in_state')",
                      key.data());
  } else if (!sight.is_running && (key == "state" || sight.outcome == BehaviorEnd::none)) {
    lua_pushnil(L);
  } else {
    push_text(L, key == "outcome" ? to_string(sight.outcome) : key == "reason" ? sight.reason : sight.state);
  }
  return 1;
}

int refuse_setting_called(lua_State* L) {
  return luaL_error(L, "called is read-only: a behavior cannot set the state of another one");
}

/// Gives the table on top of the stack this function as __index, and makes it read-only.
void set_called_reader(lua_State* L, lua_CFunction read, int upvalues) {
  lua_createtable(L, 0, 3);
  lua_insert(L, -1 - upvalues);
  lua_pushcclosure(L, read, upvalues);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, refuse_setting_called);
  lua_setfield(L, -2, "__newindex");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
}

/// Arguments: `called`, a name. The table stays in `called`, so that it is made once.
int find_behavior(lua_State* L) {
  Sandbox::of(L).charge(kPriceOfCalled);
  luaL_checkstring(L, 2);
  lua_newtable(L);
  push_objects(L);
  lua_pushvalue(L, 2);
  set_called_reader(L, read_called, kBehavior);
  lua_pushvalue(L, 2);
  lua_pushvalue(L, -2);
  lua_rawset(L, 1);
  return 1;
}

/// Whether the behavior has ended so.
int has_ended(lua_State* L) {
  const CalledSight sight = sight_of(L, lua_tostring(L, lua_upvalueindex(kBehavior)));
  const auto outcome = static_cast<BehaviorEnd>(lua_tointeger(L, lua_upvalueindex(kAwaitedEnd)));
  lua_pushboolean(L, sight.is_running && sight.outcome == outcome ? 1 : 0);
  return 1;
}

/// Argument: the name of a behavior. Returns a condition.
template <BehaviorEnd kAwaited>
int await(lua_State* L) {
  luaL_checkstring(L, 1);
  push_objects(L);
  lua_pushvalue(L, 1);
  lua_pushinteger(L, static_cast<lua_Integer>(kAwaited));
  lua_pushcclosure(L, has_ended, kAwaitedEnd);
  return 1;
}

}  // namespace

void add_called_view(lua_State* L, const MachineDirectory& directory, const ScriptActions& actions) {
  const auto push_pair = [&] {
    // Lua has no pointer to const; both are only read through it.
    lua_pushlightuserdata(L, const_cast<MachineDirectory*>(&directory));
    lua_pushlightuserdata(L, const_cast<ScriptActions*>(&actions));
  };
  lua_newtable(L);
  push_pair();
  set_called_reader(L, find_behavior, kActions);
  lua_setglobal(L, "called");
  push_pair();
  lua_pushcclosure(L, await<BehaviorEnd::done>, kActions);
  lua_setglobal(L, "done");
  push_pair();
  lua_pushcclosure(L, await<BehaviorEnd::failed>, kActions);
  lua_setglobal(L, "failed");
}

std::string awaited_behavior(lua_State* L, int function) {
  std::string behavior;
  if (function == LUA_NOREF) return behavior;
  lua_rawgeti(L, LUA_REGISTRYINDEX, function);
  if (lua_tocfunction(L, -1) == has_ended && lua_getupvalue(L, -1, kBehavior) != nullptr) {
    behavior = lua_tostring(L, -1);
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  return behavior;
}

}  // namespace reorient

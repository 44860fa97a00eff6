// SPDX-License-Identifier: MIT
#include "engine/script/language/application_tables.h"

#include <array>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "engine/parameters/nearest_name.h"
#include "engine/script/language/behavior_language.h"
#include "engine/script/language/lua_fields.h"
#include "engine/script/sandbox/sandbox.h"

namespace reorient {
namespace {

/// What `input`, `input.age` and `input.valid` read of a value.
enum class Aspect { content, age, validity };
constexpr std::array<const char*, 3> kRoots{"input", "input.age", "input.valid"};

constexpr std::int64_t kPriceOfRead = 20;

struct Metamethod {
  const char* event;
  lua_CFunction call;
};

// Upvalues of a table of values: the language, the aspect, the name of the table, its entries (the index of a value, or
// a table of more values), and the tables that were made of values, at their index, with the revision at -1 - index.
constexpr int kLanguage = 1, kAspect = 2, kName = 3, kEntries = 4, kMade = 5;

BehaviorLanguage& language_of(lua_State* L) {
  return *static_cast<BehaviorLanguage*>(lua_touserdata(L, lua_upvalueindex(kLanguage)));
}

std::vector<std::string> names_in(lua_State* L, int table) {
  std::vector<std::string> keys;
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) keys.emplace_back(lua_tostring(L, -2));
  return keys;
}

/// A value that is a table is made again only after it changed.
void push_made(lua_State* L, std::size_t index, const DeclaredValue& value, const ValueState& state) {
  const auto key = static_cast<lua_Integer>(index);
  lua_rawgeti(L, lua_upvalueindex(kMade), -1 - key);
  const bool is_current = lua_isinteger(L, -1) && lua_tointeger(L, -1) == static_cast<lua_Integer>(state.revision);
  lua_pop(L, 1);
  if (!is_current) {
    constexpr std::int64_t kPriceOfRecord = 50;
    Sandbox::of(L).charge(kPriceOfRecord * (1 + static_cast<std::int64_t>(state.records)));
    push_content(L, value, state.data, state.records, "input." + value.name);
    lua_rawseti(L, lua_upvalueindex(kMade), key);
    lua_pushinteger(L, static_cast<lua_Integer>(state.revision));
    lua_rawseti(L, lua_upvalueindex(kMade), -1 - key);
  }
  lua_rawgeti(L, lua_upvalueindex(kMade), key);
}

void push_value(lua_State* L, std::size_t index) {
  BehaviorLanguage& language = language_of(L);
  const ApplicationState& application = language.application();
  const DeclaredValue& value = application.declared().values[index];
  if (language.actions().is_loading())
    luaL_error(L, "input.%s has no value while the script is loaded", value.name.c_str());
  const double now = language.actions().time();
  switch (static_cast<Aspect>(lua_tointeger(L, lua_upvalueindex(kAspect)))) {
    case Aspect::age:
      return lua_pushnumber(L, application.age(index, now));
    case Aspect::validity:
      return lua_pushboolean(L, application.is_valid(index, now) ? 1 : 0);
    case Aspect::content:
      break;
  }
  const ValueState& state = application.values()[index];
  const bool is_table = value.is_list() || numbers_of(value.fields.front().type) > 1;
  if (is_table) return push_made(L, index, value, state);
  push_content(L, value, state.data, state.records, {});
}

/// Replaces the entry on top of the stack by what the script reads.
void resolve(lua_State* L) {
  if (!lua_isinteger(L, -1)) return;
  const lua_Integer index = lua_tointeger(L, -1);
  lua_pop(L, 1);
  push_value(L, static_cast<std::size_t>(index));
}

[[noreturn]] void refuse_unknown(lua_State* L, const std::string& table, const char* what) {
  const ApplicationInterface& declared = language_of(L).application().declared();
  const std::string key = luaL_tolstring(L, 2, nullptr);
  std::string hint = did_you_mean(key, names_in(L, lua_upvalueindex(kEntries)));
  if (hint.empty() && declared.is_empty()) hint = " (this run has no interface of an application: --interface)";
  luaL_error(L, "%s has no %s '%s'%s", table.c_str(), what, key.c_str(), hint.c_str());
  throw std::logic_error("luaL_error returned");
}

/// Arguments: the table of values, a key.
int read_input(lua_State* L) {
  Sandbox::of(L).charge(kPriceOfRead);
  lua_pushvalue(L, 2);
  if (lua_type(L, 2) == LUA_TSTRING && lua_rawget(L, lua_upvalueindex(kEntries)) != LUA_TNIL) {
    resolve(L);
    return 1;
  }
  refuse_unknown(L, lua_tostring(L, lua_upvalueindex(kName)), "value");
}

/// `pairs` over a table of values iterates over what it contains now.
int pairs_of_input(lua_State* L) {
  lua_getglobal(L, "pairs");
  lua_newtable(L);
  const int copy = lua_gettop(L);
  for (lua_pushnil(L); lua_next(L, lua_upvalueindex(kEntries)) != 0;) {
    Sandbox::of(L).charge(kPriceOfRead);
    lua_pushvalue(L, -2);
    lua_insert(L, -2);  // key, key, entry
    resolve(L);
    lua_rawset(L, copy);
  }
  lua_call(L, 1, 3);
  return 3;
}

int refuse_setting_input(lua_State* L) { return luaL_error(L, "input is read-only: the application sets its values"); }
int refuse_setting_action(lua_State* L) {
  return luaL_error(L, "action is read-only: request an action as in action.kick { foot = \"left\" }");
}

/// Gives the empty table on top of the stack the metatable above it, and pops that.
void close_with(lua_State* L, lua_CFunction refuse) {
  lua_pushcfunction(L, refuse);
  lua_setfield(L, -2, "__newindex");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
}

/// Replaces the entries on top of the stack by the table that the script gets. `made`: its index on the stack.
void push_values(lua_State* L, BehaviorLanguage& language, Aspect aspect, const std::string& name, int made) {
  const int entries = lua_gettop(L);
  lua_newtable(L);
  lua_createtable(L, 0, 4);
  for (const auto& [event, call] : {Metamethod{"__index", read_input}, Metamethod{"__pairs", pairs_of_input}}) {
    lua_pushlightuserdata(L, &language);
    lua_pushinteger(L, static_cast<lua_Integer>(aspect));
    lua_pushlstring(L, name.data(), name.size());
    lua_pushvalue(L, entries);
    lua_pushvalue(L, made);
    lua_pushcclosure(L, call, 5);
    lua_setfield(L, -2, event);
  }
  close_with(L, refuse_setting_input);
  lua_remove(L, entries);
}

/// Pushes the entries of `input`, `input.age` or `input.valid`.
void push_entries(lua_State* L, BehaviorLanguage& language, Aspect aspect, int made) {
  const std::string root = kRoots[static_cast<std::size_t>(aspect)];
  lua_newtable(L);
  std::map<std::string, std::map<std::string, std::size_t>> groups;
  const std::vector<DeclaredValue>& values = language.application().declared().values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t dot = values[i].name.find('.');
    if (dot != std::string::npos) {
      groups[values[i].name.substr(0, dot)][values[i].name.substr(dot + 1)] = i;
    } else {
      lua_pushinteger(L, static_cast<lua_Integer>(i));
      lua_setfield(L, -2, values[i].name.c_str());
    }
  }
  for (const auto& [group, members] : groups) {
    lua_newtable(L);
    for (const auto& [name, index] : members) {
      lua_pushinteger(L, static_cast<lua_Integer>(index));
      lua_setfield(L, -2, name.c_str());
    }
    push_values(L, language, aspect, std::string(root).append(".").append(group), made);
    lua_setfield(L, -2, group.c_str());
  }
}

void add_input(lua_State* L, BehaviorLanguage& language) {
  lua_newtable(L);
  const int made = lua_gettop(L);
  push_entries(L, language, Aspect::content, made);
  for (const Aspect aspect : {Aspect::age, Aspect::validity}) {
    push_entries(L, language, aspect, made);
    push_values(L, language, aspect, kRoots[static_cast<std::size_t>(aspect)], made);
    lua_setfield(L, -2, aspect == Aspect::age ? "age" : "valid");
  }
  push_values(L, language, Aspect::content, kRoots[0], made);
  lua_setglobal(L, "input");
  lua_pop(L, 1);
}

// ---- actions

/// Upvalues: the language, the index of the action. Arguments: its table, a key.
int read_action(lua_State* L) {
  Sandbox::of(L).charge(kPriceOfRead);
  BehaviorLanguage& language = language_of(L);
  const auto index = static_cast<std::size_t>(lua_tointeger(L, lua_upvalueindex(2)));
  const std::string& name = language.application().declared().actions[index].name;
  if (language.actions().is_loading())
    return luaL_error(L, "action.%s has no state while the script is loaded", name.c_str());
  const ActionStatus& status = language.application().actions()[index];
  const RefusedAction* const refused =
      language.application().refused(language.actions().running()->definition().name_id, index);
  const std::string_view key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
  if (key == "state") {
    const std::string_view state = to_string(refused != nullptr ? ActionState::failed : status.state);
    lua_pushlstring(L, state.data(), state.size());
  } else if (key == "reason" && refused != nullptr) {
    if (refused->outranked_by == kNoName) {
      lua_pushliteral(L, "the action already runs with other arguments");
    } else {
      lua_pushfstring(L, "outranked by %s", language.actions().name_of(refused->outranked_by).c_str());
    }
  } else if (key == "reason") {
    lua_pushlstring(L, status.reason.data(), status.reason.size());
  } else if (key == "time_in_state") {
    lua_pushnumber(L, language.actions().time() - (refused != nullptr ? refused->since : status.since));
  } else {
    return luaL_error(L, "action.%s has no field '%s' (expected state, reason or time_in_state)", name.c_str(),
                      luaL_tolstring(L, 2, nullptr));
  }
  return 1;
}

/// Upvalues: the language, the index of the action. Arguments: its table, the arguments.
int request_action(lua_State* L) {
  BehaviorLanguage& language = language_of(L);
  const auto index = static_cast<std::uint16_t>(lua_tointeger(L, lua_upvalueindex(2)));
  const DeclaredAction& declared = language.application().declared().actions[index];
  constexpr std::int64_t kPriceOfField = 20;
  Sandbox::of(L).charge(kPriceOfRead + kPriceOfField * static_cast<std::int64_t>(declared.arguments.size()));
  std::string failure;
  try {
    if (lua_gettop(L) > 2)
      throw std::runtime_error("action." + declared.name + ": expected one table of arguments, found more values");
    lua_settop(L, 2);
    language.actions().request(index, read_record(L, 2, declared.arguments, "action." + declared.name));
    return 0;
  } catch (const std::runtime_error& error) {
    failure = error.what();
  }
  return luaL_error(L, "%s", failure.c_str());
}

/// Upvalues: the language, the tables of the actions at kEntries. Arguments: `action`, a key.
int find_action(lua_State* L) {
  Sandbox::of(L).charge(kPriceOfRead);
  lua_pushvalue(L, 2);
  if (lua_type(L, 2) == LUA_TSTRING && lua_rawget(L, lua_upvalueindex(kEntries)) != LUA_TNIL) return 1;
  refuse_unknown(L, "action", "action");
}

void add_action(lua_State* L, BehaviorLanguage& language) {
  const std::vector<DeclaredAction>& actions = language.application().declared().actions;
  lua_newtable(L);
  lua_createtable(L, 0, 3);
  lua_pushlightuserdata(L, &language);
  lua_pushnil(L);
  lua_pushnil(L);
  lua_createtable(L, 0, static_cast<int>(actions.size()));
  for (std::size_t i = 0; i < actions.size(); ++i) {
    lua_newtable(L);
    lua_createtable(L, 0, 4);
    for (const auto& [event, call] : {Metamethod{"__index", read_action}, Metamethod{"__call", request_action}}) {
      lua_pushlightuserdata(L, &language);
      lua_pushinteger(L, static_cast<lua_Integer>(i));
      lua_pushcclosure(L, call, 2);
      lua_setfield(L, -2, event);
    }
    close_with(L, refuse_setting_action);
    lua_setfield(L, -2, actions[i].name.c_str());
  }
  lua_pushcclosure(L, find_action, kEntries);
  lua_setfield(L, -2, "__index");
  close_with(L, refuse_setting_action);
  lua_setglobal(L, "action");
}

}  // namespace

void add_application_tables(lua_State* L, BehaviorLanguage& language) {
  add_input(L, language);
  add_action(L, language);
}

}  // namespace reorient

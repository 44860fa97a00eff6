// SPDX-License-Identifier: MIT
#include "engine/script/language/machine_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "engine/parameters/nearest_name.h"
#include "engine/script/language/called_view.h"
#include "engine/script/language/script_arguments.h"

namespace reorient {
namespace {

constexpr int kDeepestNesting = 16;
constexpr std::size_t kMostStates = 1000;
constexpr std::size_t kMostTransitions = 2000;  // one table can be in many states, so a few lines can make millions

constexpr std::size_t kMostCalls = 100;

// Their addresses are keys that no script can write.
const char kMarked = 'm';
const char kMarkedName = 'n';
const char kMarkedLine = 'l';
const char kMarkedFile = 'f';

constexpr const char* kMachineKeys[] = {"priority", "initial", "common", "enter", "update", "exit"};
constexpr const char* kScenarioKeys[] = {"priority",  "initial", "common",    "enter", "update",   "exit",
                                         "behaviors", "room",    "hall_seed", "field", "interface"};
constexpr const char* kStateKeys[] = {"initial", "history", "common", "enter", "update", "exit", "publishes", "ends"};
constexpr const char* kExpectedPriority = "priority: expected a finite number, or a table such as { 35, head = 50 }";
constexpr const char* kTransitionKeys[] = {"when", "lasting", "after", "because"};

std::optional<Marked> mark_of(lua_State* L, int table) {
  const bool is_marked = lua_rawgetp(L, table, &kMarked) != LUA_TNIL;
  const auto what = static_cast<Marked>(lua_tointeger(L, -1));
  lua_pop(L, 1);
  return is_marked ? std::optional(what) : std::nullopt;
}

std::string short_name(const std::string& parameter) { return parameter.substr(parameter.find('.') + 1); }

std::vector<std::string> short_names(std::span<const std::string> parameters) {
  std::vector<std::string> names;
  for (const std::string& parameter : parameters) names.push_back(short_name(parameter));
  return names;
}

}  // namespace

int raw_field(lua_State* L, int index, const char* name) {
  const int table = lua_absindex(L, index);
  lua_pushstring(L, name);
  return lua_rawget(L, table);
}

void mark(lua_State* L, int table, Marked what, Mark mark) {
  lua_pushinteger(L, static_cast<lua_Integer>(what));
  lua_rawsetp(L, table, &kMarked);
  lua_pushvalue(L, mark.name);
  lua_rawsetp(L, table, &kMarkedName);
  lua_pushvalue(L, mark.line);
  lua_rawsetp(L, table, &kMarkedLine);
  lua_pushvalue(L, mark.file);
  lua_rawsetp(L, table, &kMarkedFile);
}

MachineReader::MachineReader(lua_State* L, MachineDefinition& machine, std::span<const std::string> parameters,
                             std::span<const std::string> body_parts, const PlacesOf& places_of,
                             std::vector<DeclarationError>& errors)
    : lua_(L),
      machine_(machine),
      parameters_(parameters),
      body_parts_(body_parts),
      places_of_(places_of),
      errors_(errors) {}

const SourceLocations& MachineReader::places() {
  const SourceLocations*& known = places_[here_.file];
  if (known == nullptr) known = &places_of_(here_.file);
  return *known;
}

void MachineReader::note_at(const std::string& key, const std::string& message) {
  errors_.push_back({places().key(key, here_.position, here_.end).value_or(here_.position), message, here_.file});
}

void MachineReader::read(int table, int line) {
  here_.file = machine_.file;
  SourceLocations::Table place = places().table(machine_.is_scenario ? "scenario" : "behavior", machine_.name, line);
  here_.position = place.position;
  here_.end = places().end_of(place);
  machine_.position = here_.position;
  if (machine_.is_scenario) {
    check_keys(table, kScenarioKeys);
    read_behaviors(table);
    read_setting(table);
  } else {
    check_keys(table, kMachineKeys);
  }
  machine_.priorities = read_priorities(table);
  machine_.states.emplace_back();
  machine_.states.back().file = here_.file;
  machine_.states.back().position = here_.position;
  read_state(table, 0, place);
}

void MachineReader::read_state(int table, int state, SourceLocations::Table& place) {
  if (++depth_ > kDeepestNesting)
    throw std::runtime_error("states are nested too deeply (expected at most " + std::to_string(kDeepestNesting) + ")");
  luaL_checkstack(lua_, 8, "states are nested too deeply");
  StateDefinition& definition = machine_.states[state];
  definition.initial_name = read_text(table, "initial");
  definition.enter = read_function(table, "enter");
  definition.update = read_function(table, "update");
  definition.exit = read_function(table, "exit");
  definition.publishes = read_flag(table);
  definition.ends = read_end(table);
  const int history = raw_field(lua_, table, "history");
  if (history != LUA_TNIL && history != LUA_TBOOLEAN) note_at("history", "history: expected true or false");
  definition.history = lua_toboolean(lua_, -1) != 0;
  lua_pop(lua_, 1);
  read_common(table, state, place);
  // `definition` is invalid from here: states are added.
  const auto count = static_cast<lua_Integer>(lua_rawlen(lua_, table));
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(lua_, table, i);
    read_item(lua_gettop(lua_), state, place);
    lua_pop(lua_, 1);
  }
  --depth_;
}

/// Elements of a state's table without a key: states, calls and transitions.
void MachineReader::read_item(int item, int state, SourceLocations::Table& place) {
  if (!lua_istable(lua_, item)) {
    const bool is_function = lua_isfunction(lua_, item);
    note("expected a state, a transition or a run, found a " + std::string(luaL_typename(lua_, item)) +
         (is_function ? " (a state or a run ends with a table: run \"walk_to\" { })" : ""));
    return;
  }
  const std::optional<Marked> what = mark_of(lua_, item);
  if (what == Marked::state) {
    read_inner_state(item, state);
  } else if (what == Marked::call) {
    read_call(item, state);
  } else {
    read_transition(item, state, false, place);
  }
}

void MachineReader::read_inner_state(int item, int parent) {
  if (machine_.states.size() >= kMostStates)
    throw std::runtime_error("too many states (expected at most " + std::to_string(kMostStates) + ")");
  const Here outside = here_;
  lua_rawgetp(lua_, item, &kMarkedFile);
  lua_rawgetp(lua_, item, &kMarkedLine);
  lua_rawgetp(lua_, item, &kMarkedName);
  StateDefinition inner;
  inner.name = lua_tostring(lua_, -1);
  here_.file = lua_tostring(lua_, -3);
  SourceLocations::Table place = places().table("state", inner.name, static_cast<int>(lua_tointeger(lua_, -2)));
  lua_pop(lua_, 3);
  here_.position = place.position;
  here_.end = places().end_of(place);
  const std::string& outer = machine_.states[parent].path;
  inner.path = outer.empty() ? inner.name : outer + "/" + inner.name;
  inner.parent = parent;
  inner.file = here_.file;
  inner.position = here_.position;
  check_keys(item, kStateKeys);
  const int index = static_cast<int>(machine_.states.size());
  machine_.states.push_back(std::move(inner));
  machine_.states[parent].children.push_back(index);
  read_state(item, index, place);
  here_ = outside;
}

void MachineReader::read_common(int table, int state, SourceLocations::Table& place) {
  constexpr const char* kMisread = "common: expected a list of transitions: common = { { \"target\", when = ... } }";
  const int type = raw_field(lua_, table, "common");
  const int list = lua_gettop(lua_);
  if (type != LUA_TNIL && type != LUA_TTABLE) note_at("common", kMisread);
  const auto count = type == LUA_TTABLE ? static_cast<lua_Integer>(lua_rawlen(lua_, list)) : 0;
  for (lua_Integer i = 1; i <= count; ++i) {
    if (lua_rawgeti(lua_, list, i) == LUA_TTABLE && !mark_of(lua_, lua_gettop(lua_))) {
      read_transition(lua_gettop(lua_), state, true, place);
    } else {
      note_at("common", kMisread);
    }
    lua_pop(lua_, 1);
  }
  lua_pop(lua_, 1);
}

void MachineReader::read_transition(int table, int state, bool common, SourceLocations::Table& place) {
  if (machine_.transitions.size() >= kMostTransitions)
    throw std::runtime_error("too many transitions (expected at most " + std::to_string(kMostTransitions) + ")");
  const TextPosition outside = here_.position;
  TransitionDefinition transition;
  transition.from = state;
  transition.common = common;
  const bool has_target = lua_rawgeti(lua_, table, 1) == LUA_TSTRING;
  if (has_target) transition.target = lua_tostring(lua_, -1);
  lua_pop(lua_, 1);
  if (transition.target.empty()) return note("transition: expected the name of the target state as first element");
  const std::optional<TextPosition> written = places().transition(place, transition.target, common);
  if (!written) transition.maker = maker_of(table);
  here_.position = written.value_or(place.position);
  transition.position = here_.position;
  check_keys(table, kTransitionKeys);
  transition.when = read_function(table, "when");
  transition.awaits = awaited_behavior(lua_, transition.when);
  transition.lasting = read_dwell(table, "lasting");
  transition.after = read_dwell(table, "after");
  transition.because = read_text(table, "because");
  machine_.states[state].transitions.push_back(static_cast<int>(machine_.transitions.size()));
  machine_.transitions.push_back(std::move(transition));
  here_.position = outside;
}

void MachineReader::read_call(int table, int state) {
  if (machine_.is_scenario) return note("run: a scenario cannot run a behavior; list it in `behaviors`");
  if (machine_.calls.size() >= kMostCalls)
    throw std::runtime_error("too many runs (expected at most " + std::to_string(kMostCalls) + ")");
  const Here outside = here_;
  CallDefinition call;
  call.state = state;
  lua_rawgetp(lua_, table, &kMarkedFile);
  lua_rawgetp(lua_, table, &kMarkedLine);
  lua_rawgetp(lua_, table, &kMarkedName);
  call.behavior = lua_tostring(lua_, -1);
  here_.file = lua_tostring(lua_, -3);
  const SourceLocations::Table place = places().table("run", call.behavior, static_cast<int>(lua_tointeger(lua_, -2)));
  lua_pop(lua_, 3);
  here_.position = call.position = place.position;
  here_.end = places().end_of(place);
  for (lua_pushnil(lua_); lua_next(lua_, table) != 0; lua_pop(lua_, 1)) {
    if (lua_type(lua_, -2) == LUA_TSTRING) {
      read_call_argument(call);
    } else if (lua_type(lua_, -2) != LUA_TLIGHTUSERDATA) {
      note("run \"" + call.behavior + "\": expected named arguments, as in { x = 1.0 }");
    }
  }
  std::sort(call.arguments.begin(), call.arguments.end(),
            [](const CallArgument& left, const CallArgument& right) { return left.name < right.name; });
  machine_.calls.push_back(std::move(call));
  here_ = outside;
}

/// The name and the value are on top of the stack.
void MachineReader::read_call_argument(CallDefinition& call) {
  CallArgument argument;
  argument.name = lua_tostring(lua_, -2);
  argument.position = places().key(argument.name, here_.position, here_.end).value_or(here_.position);
  if (lua_isfunction(lua_, -1)) {
    lua_pushvalue(lua_, -1);
    argument.function = luaL_ref(lua_, LUA_REGISTRYINDEX);
  } else if (std::optional<ParameterValue> value = parameter_value(lua_, -1)) {
    argument.value = std::move(*value);
  } else {
    return note_at(argument.name, argument.name + ": expected a number, a boolean, a string, or a function, found a " +
                                      luaL_typename(lua_, -1));
  }
  call.arguments.push_back(std::move(argument));
}

/// File of the functions that made a transition, since Lua has positions of functions, but not of tables. Empty: the
/// file that is being read, or unknown.
std::string MachineReader::maker_of(int transition) {
  for (const char* const key : {"when", "lasting", "after"}) {
    if (raw_field(lua_, transition, key) != LUA_TFUNCTION) {
      lua_pop(lua_, 1);
      continue;
    }
    lua_Debug function;
    lua_getinfo(lua_, ">S", &function);
    const std::string_view source = function.source;
    if (source.starts_with('@') && source.substr(1) != here_.file) return std::string(source.substr(1));
  }
  return {};
}

Dwell MachineReader::read_dwell(int table, const char* key) {
  Dwell dwell;
  const int type = raw_field(lua_, table, key);
  if (type == LUA_TNUMBER) {
    dwell.kind = Dwell::Kind::seconds;
    dwell.seconds = lua_tonumber(lua_, -1);
    lua_pushvalue(lua_, -1);
    dwell.text = std::string(lua_tostring(lua_, -1)) + " s";
    lua_pop(lua_, 1);
    if (!(dwell.seconds >= 0.0) || !std::isfinite(dwell.seconds))
      note_at(key, std::string(key) + ": expected a non-negative number of seconds");
  } else if (type == LUA_TFUNCTION) {
    dwell.kind = Dwell::Kind::function;
    dwell.text = "the result of a function";
    lua_pushvalue(lua_, -1);
    dwell.index = luaL_ref(lua_, LUA_REGISTRYINDEX);
  } else if (type == LUA_TSTRING) {
    dwell.kind = Dwell::Kind::parameter;
    dwell.text = lua_tostring(lua_, -1);
    dwell.index = find_parameter(dwell.text);
    if (dwell.index < 0)
      note_at(key, "unknown param '" + dwell.text + "'" + did_you_mean(dwell.text, short_names(parameters_)));
  } else if (type != LUA_TNIL) {
    note_at(key, std::string(key) +
                     ": expected a number of seconds, the name of a param, or a function that returns seconds");
  }
  lua_pop(lua_, 1);
  return dwell;
}

/// -1: unknown param. Searches backward: a file's own params come after those of the libraries that it requires.
int MachineReader::find_parameter(const std::string& name) {
  for (std::size_t i = parameters_.size(); i-- > 0;) {
    if (parameters_[i] == name || short_name(parameters_[i]) == name) return static_cast<int>(i);
  }
  return -1;
}

int MachineReader::read_function(int table, const char* key) {
  const int type = raw_field(lua_, table, key);
  if (type == LUA_TFUNCTION) return luaL_ref(lua_, LUA_REGISTRYINDEX);
  lua_pop(lua_, 1);
  if (type != LUA_TNIL) note_at(key, std::string(key) + ": expected a function, found a " + lua_typename(lua_, type));
  return LUA_NOREF;
}

std::string MachineReader::read_text(int table, const char* key) {
  std::string text;
  const int type = raw_field(lua_, table, key);
  if (type != LUA_TNIL && type != LUA_TSTRING)
    note_at(key, std::string(key) + ": expected a string, found a " + lua_typename(lua_, type));
  if (type == LUA_TSTRING) text = lua_tostring(lua_, -1);
  lua_pop(lua_, 1);
  return text;
}

/// The name must be an identifier, because scripts write `published.NAME`.
std::string MachineReader::read_flag(int table) {
  std::string flag = read_text(table, "publishes");
  const auto fits = [](char c) { return c == '_' || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
  const bool is_name = std::all_of(flag.begin(), flag.end(), fits) && (flag.empty() || flag[0] > '9');
  if (is_name) return flag;
  note_at("publishes", "publishes: expected a name of a-z, 0-9 and _, such as \"pose_is_searched\"");
  return {};
}

BehaviorEnd MachineReader::read_end(int table) {
  const std::string text = read_text(table, "ends");
  if (text == to_string(BehaviorEnd::done)) return BehaviorEnd::done;
  if (text == to_string(BehaviorEnd::failed)) return BehaviorEnd::failed;
  if (!text.empty()) note_at("ends", "ends: expected \"done\" or \"failed\", found \"" + text + "\"");
  return BehaviorEnd::none;
}

/// `priority = 35`, or `priority = { 35, head = 50 }`.
Priorities MachineReader::read_priorities(int table) {
  Priorities priorities;
  const int type = raw_field(lua_, table, "priority");
  const int value = lua_gettop(lua_);
  const bool has_parts = type == LUA_TTABLE && !machine_.is_scenario;
  if (has_parts) lua_rawgeti(lua_, value, 1);
  if (lua_type(lua_, -1) == LUA_TNUMBER && std::isfinite(lua_tonumber(lua_, -1))) {
    priorities.all = lua_tonumber(lua_, -1);
  } else if (type != LUA_TNIL) {
    note_at("priority", machine_.is_scenario ? "priority: expected a finite number" : kExpectedPriority);
  }
  if (has_parts) read_part_priorities(value, priorities);
  lua_settop(lua_, value - 1);
  return priorities;
}

void MachineReader::read_part_priorities(int table, Priorities& priorities) {
  for (lua_pushnil(lua_); lua_next(lua_, table) != 0; lua_pop(lua_, 1)) {
    if (lua_isinteger(lua_, -2) != 0 && lua_tointeger(lua_, -2) == 1) continue;
    if (lua_type(lua_, -2) != LUA_TSTRING) return note_at("priority", kExpectedPriority);
    const std::string name = lua_tostring(lua_, -2);
    const auto part = std::find(body_parts_.begin(), body_parts_.end(), name);
    if (part == body_parts_.end())
      return note_at("priority", "priority: unknown part of the body '" + name + "'" + did_you_mean(name, body_parts_));
    if (lua_type(lua_, -1) != LUA_TNUMBER || !std::isfinite(lua_tonumber(lua_, -1)))
      return note_at("priority", "priority: " + name + ": expected a finite number");
    priorities.parts.push_back({static_cast<BodyPart>(part - body_parts_.begin()), lua_tonumber(lua_, -1)});
  }
  // The order of Lua's tables is not that of the text.
  std::sort(priorities.parts.begin(), priorities.parts.end(),
            [](const PartPriority& left, const PartPriority& right) { return left.part < right.part; });
}

void MachineReader::read_behaviors(int table) {
  const int type = raw_field(lua_, table, "behaviors");
  if (type != LUA_TNIL && type != LUA_TTABLE) note_at("behaviors", "behaviors: expected a list of names");
  const auto count = type == LUA_TTABLE ? static_cast<lua_Integer>(lua_rawlen(lua_, -1)) : 0;
  for (lua_Integer i = 1; i <= count; ++i) {
    if (lua_rawgeti(lua_, -1, i) == LUA_TSTRING) {
      machine_.behaviors.emplace_back(lua_tostring(lua_, -1));
    } else {
      note_at("behaviors", "behaviors: expected a list of names");
    }
    lua_pop(lua_, 1);
  }
  lua_pop(lua_, 1);
}

void MachineReader::read_setting(int table) {
  machine_.setting.room = read_text(table, "room");
  machine_.setting.field = read_text(table, "field");
  machine_.setting.interface = read_text(table, "interface");
  const int type = raw_field(lua_, table, "hall_seed");
  const bool fits = lua_isinteger(lua_, -1) != 0 && lua_tointeger(lua_, -1) >= 0;
  if (fits) machine_.setting.hall_seed = static_cast<std::uint64_t>(lua_tointeger(lua_, -1));
  lua_pop(lua_, 1);
  if (type != LUA_TNIL && !fits) note_at("hall_seed", "hall_seed: expected a non-negative whole number");
  if (machine_.setting.hall_seed && !machine_.setting.room.empty())
    note_at("hall_seed", "expected a room or a hall_seed, found both");
}

void MachineReader::check_keys(int table, std::span<const char* const> known) {
  const std::vector<std::string> names(known.begin(), known.end());
  for (lua_pushnil(lua_); lua_next(lua_, table) != 0; lua_pop(lua_, 1)) {
    if (lua_type(lua_, -2) != LUA_TSTRING) continue;
    const std::string key = lua_tostring(lua_, -2);
    const bool found = std::find(names.begin(), names.end(), key) != names.end();
    if (!found) note_at(key, "unknown key '" + key + "'" + did_you_mean(key, names));
  }
}

}  // namespace reorient

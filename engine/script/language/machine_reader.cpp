#include "engine/script/language/machine_reader.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/parameters/nearest_name.h"
#include "engine/script/sandbox/sandbox.h"

namespace reorient {
namespace {

constexpr int kDeepestNesting = 16;
constexpr std::size_t kMostStates = 1000;
constexpr std::size_t kMostTransitions = 2000;  // one table can stand in many states, and a few lines make millions
constexpr std::size_t kLettersPerInstruction = 32;

// Keys that no script can write: their addresses.
const char kStateName = 'n';
const char kStateLine = 'l';

constexpr const char* kMachineKeys[] = {"priority", "initial", "always", "enter", "update", "exit"};
constexpr const char* kScenarioKeys[] = {"priority", "initial", "always", "enter", "update", "exit", "behaviors"};
constexpr const char* kStateKeys[] = {"initial", "history", "always", "enter", "update", "exit"};
constexpr const char* kTransitionKeys[] = {"when", "lasting", "after", "because"};

int raw_field(lua_State* L, int table, const char* name) {
  lua_pushstring(L, name);
  return lua_rawget(L, table);
}

bool is_state(lua_State* L, int table) {
  const bool marked = lua_rawgetp(L, table, &kStateName) != LUA_TNIL;
  lua_pop(L, 1);
  return marked;
}

}  // namespace

void mark_state(lua_State* L, int table, int name, int line) {
  lua_pushvalue(L, name);
  lua_rawsetp(L, table, &kStateName);
  lua_pushvalue(L, line);
  lua_rawsetp(L, table, &kStateLine);
}

MachineReader::MachineReader(lua_State* L, MachineDefinition& machine, std::span<const std::string> parameters,
                             std::string_view text)
    : lua_(L), machine_(machine), parameters_(parameters), text_(text), line_(machine.line) {}

void MachineReader::refuse(const std::string& message) const {
  throw std::runtime_error(machine_.file + ":" + std::to_string(line_) + ": " + message);
}

void MachineReader::read(int table) {
  if (machine_.is_scenario) {
    check_keys(table, kScenarioKeys);
    read_behaviors(table);
  } else {
    check_keys(table, kMachineKeys);
  }
  const int type = raw_field(lua_, table, "priority");
  if (type != LUA_TNIL && type != LUA_TNUMBER) refuse("priority is a number");
  machine_.priority = lua_tonumber(lua_, -1);
  if (!std::isfinite(machine_.priority)) refuse("priority is a finite number");
  lua_pop(lua_, 1);
  machine_.states.emplace_back();
  machine_.states.back().line = machine_.line;
  read_state(table, 0);
}

void MachineReader::read_state(int table, int state) {
  if (++depth_ > kDeepestNesting) refuse("states nest too deeply");
  luaL_checkstack(lua_, 8, "states nest too deeply");
  StateDefinition& definition = machine_.states[state];
  definition.initial_name = read_text(table, "initial");
  definition.enter = read_function(table, "enter");
  definition.update = read_function(table, "update");
  definition.exit = read_function(table, "exit");
  raw_field(lua_, table, "history");
  definition.history = lua_toboolean(lua_, -1) != 0;
  lua_pop(lua_, 1);
  read_transitions(table, state);
  read_items(table, state);
  --depth_;
}

/// What stands in the table without a name: states and transitions. (`definition` would dangle: states are added.)
void MachineReader::read_items(int table, int state) {
  const auto count = static_cast<lua_Integer>(lua_rawlen(lua_, table));
  for (lua_Integer i = 1; i <= count; ++i) {
    if (lua_rawgeti(lua_, table, i) != LUA_TTABLE) {
      refuse("here stand states and transitions, not a " + std::string(luaL_typename(lua_, -1)));
    }
    const int item = lua_gettop(lua_);
    if (!is_state(lua_, item)) {
      read_transition(item, state, false);
      lua_pop(lua_, 1);
      continue;
    }
    if (machine_.states.size() >= kMostStates) refuse("too many states");
    const int line_before = line_;
    lua_rawgetp(lua_, item, &kStateLine);
    line_ = static_cast<int>(lua_tointeger(lua_, -1));
    lua_rawgetp(lua_, item, &kStateName);
    StateDefinition inner;
    inner.name = lua_tostring(lua_, -1);
    inner.path = machine_.states[state].path.empty() ? inner.name : machine_.states[state].path + "/" + inner.name;
    inner.parent = state;
    inner.line = line_;
    lua_pop(lua_, 2);
    check_keys(item, kStateKeys);
    const int index = static_cast<int>(machine_.states.size());
    machine_.states.push_back(std::move(inner));
    machine_.states[state].children.push_back(index);
    read_state(item, index);
    line_ = std::max(line_, line_before);
    lua_pop(lua_, 1);
  }
}

void MachineReader::read_transitions(int table, int state) {
  const int line_before = line_;
  const int type = raw_field(lua_, table, "always");
  const int list = lua_gettop(lua_);
  if (type != LUA_TNIL && type != LUA_TTABLE)
    refuse("always is a list of transitions: always = { { \"target\", when = ... } }");
  const auto count = type == LUA_TTABLE ? static_cast<lua_Integer>(lua_rawlen(lua_, list)) : 0;
  for (lua_Integer i = 1; i <= count; ++i) {
    if (lua_rawgeti(lua_, list, i) != LUA_TTABLE || is_state(lua_, lua_gettop(lua_))) {
      refuse("always is a list of transitions: always = { { \"target\", when = ... } }");
    }
    read_transition(lua_gettop(lua_), state, true);
    lua_pop(lua_, 1);
  }
  line_ = line_before;
  lua_pop(lua_, 1);
}

void MachineReader::read_transition(int table, int state, bool always) {
  if (machine_.transitions.size() >= kMostTransitions) refuse("too many transitions");
  const int line_before = line_;
  TransitionDefinition transition;
  transition.from = state;
  transition.always = always;
  if (lua_rawgeti(lua_, table, 1) != LUA_TSTRING)
    refuse("a transition begins with the name of the state that it leads to");
  transition.target = lua_tostring(lua_, -1);
  lua_pop(lua_, 1);
  if (transition.target.empty()) refuse("a transition begins with the name of the state that it leads to");
  line_ = line_of(transition.target);
  check_keys(table, kTransitionKeys);
  transition.line = line_;
  transition.when = read_function(table, "when");
  transition.lasting = read_dwell(table, "lasting");
  transition.after = read_dwell(table, "after");
  transition.because = read_text(table, "because");
  machine_.states[state].transitions.push_back(static_cast<int>(machine_.transitions.size()));
  machine_.transitions.push_back(std::move(transition));
  line_ = std::max(line_, line_before);
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
      refuse(std::string(key) + " is a number of seconds, 0 or more");
  } else if (type == LUA_TFUNCTION) {
    dwell.kind = Dwell::Kind::function;
    dwell.text = "what a function says";
    lua_pushvalue(lua_, -1);
    dwell.index = luaL_ref(lua_, LUA_REGISTRYINDEX);
  } else if (type == LUA_TSTRING) {
    dwell.kind = Dwell::Kind::parameter;
    dwell.text = lua_tostring(lua_, -1);
    dwell.index = -1;
    std::vector<std::string> names(parameters_.begin(), parameters_.end());
    for (std::size_t i = names.size(); i-- > 0;) {  // backwards: this file's own come after its libraries'
      const std::string short_name = names[i].substr(names[i].find('.') + 1);
      if (names[i] == dwell.text || short_name == dwell.text) dwell.index = static_cast<int>(i);
      if (dwell.index >= 0) break;
    }
    if (dwell.index < 0) refuse("there is no param '" + dwell.text + "'" + did_you_mean(dwell.text, names));
  } else if (type != LUA_TNIL) {
    refuse(std::string(key) + " is a number of seconds, the name of a param, or a function that says how many seconds");
  }
  lua_pop(lua_, 1);
  return dwell;
}

int MachineReader::read_function(int table, const char* key) {
  const int type = raw_field(lua_, table, key);
  if (type == LUA_TNIL) {
    lua_pop(lua_, 1);
    return LUA_NOREF;
  }
  if (type != LUA_TFUNCTION) refuse(std::string(key) + " is a function, not a " + lua_typename(lua_, type));
  return luaL_ref(lua_, LUA_REGISTRYINDEX);
}

std::string MachineReader::read_text(int table, const char* key) {
  std::string text;
  const int type = raw_field(lua_, table, key);
  if (type != LUA_TNIL && type != LUA_TSTRING) refuse(std::string(key) + " is a text in quotes");
  if (type == LUA_TSTRING) text = lua_tostring(lua_, -1);
  lua_pop(lua_, 1);
  return text;
}

void MachineReader::read_behaviors(int table) {
  const int type = raw_field(lua_, table, "behaviors");
  if (type != LUA_TNIL && type != LUA_TTABLE) refuse("behaviors is a list of names");
  const auto count = type == LUA_TTABLE ? static_cast<lua_Integer>(lua_rawlen(lua_, -1)) : 0;
  for (lua_Integer i = 1; i <= count; ++i) {
    if (lua_rawgeti(lua_, -1, i) != LUA_TSTRING) refuse("behaviors is a list of names");
    machine_.behaviors.emplace_back(lua_tostring(lua_, -1));
    lua_pop(lua_, 1);
  }
  lua_pop(lua_, 1);
}

void MachineReader::check_keys(int table, std::span<const char* const> known) {
  for (lua_pushnil(lua_); lua_next(lua_, table) != 0; lua_pop(lua_, 1)) {
    if (lua_type(lua_, -2) != LUA_TSTRING) continue;
    const std::string key = lua_tostring(lua_, -2);
    const std::vector<std::string> names(known.begin(), known.end());
    bool found = false;
    for (const std::string& name : names) found |= name == key;
    if (!found) refuse("there is no '" + key + "' here" + did_you_mean(key, names));
  }
}

/// Lua does not say where a table was written; the target's name after the line that was read last does.
int MachineReader::line_of(const std::string& target) {
  Sandbox::of(lua_).charge(static_cast<std::int64_t>(text_.size() / kLettersPerInstruction));
  std::size_t at = 0;
  for (int line = 1; line < line_ && at != std::string_view::npos; ++line) {
    at = text_.find('\n', at);
    if (at != std::string_view::npos) ++at;
  }
  if (at == std::string_view::npos) return line_;
  std::size_t found = text_.find("\"" + target + "\"", at);
  if (found == std::string_view::npos) found = text_.find("'" + target + "'", at);
  if (found == std::string_view::npos) return line_;
  int line = line_;
  for (std::size_t i = at; i < found; ++i) line += text_[i] == '\n' ? 1 : 0;
  return line;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "engine/script/language/declarations.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <stdexcept>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"
#include "engine/script/language/machine_reader.h"
#include "engine/script/language/world_tables.h"
#include "engine/script/sandbox/sandbox.h"

namespace reorient {
namespace {

struct Place {
  std::string file;
  int line = 0;
};

/// Position of the script's function at `level` of the call stack.
Place place_of(lua_State* L, int level) {
  lua_Debug record;
  if (lua_getstack(L, level, &record) == 0 || lua_getinfo(L, "Sl", &record) == 0) return {};
  const std::string source = record.source;
  return {source.starts_with('@') ? source.substr(1) : source, record.currentline};
}

std::string stem_of(const std::string& file) { return std::filesystem::path(file).stem().string(); }

std::string at(const Place& place, const std::string& message) {
  return place.file + ":" + std::to_string(place.line) + ": " + message;
}

bool is_name(std::string_view text) {
  if (text.empty() || (text[0] >= '0' && text[0] <= '9')) return false;
  return text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") ==
         std::string_view::npos;
}

double raw_number(lua_State* L, int table, int index, const char* what) {
  if (lua_rawgeti(L, table, index) != LUA_TNUMBER) throw std::runtime_error(std::string(what) + ": expected numbers");
  const double number = lua_tonumber(L, -1);
  lua_pop(L, 1);
  if (!std::isfinite(number)) throw std::runtime_error(std::string(what) + ": expected finite numbers");
  return number;
}

std::string raw_text(lua_State* L, int table, const char* name) {
  std::string text;
  const int type = raw_field(L, table, name);
  if (type == LUA_TSTRING) text = lua_tostring(L, -1);
  lua_pop(L, 1);
  if (type != LUA_TSTRING && type != LUA_TNIL)
    throw std::runtime_error(std::string(name) + ": expected a string, found a " + lua_typename(L, type));
  return text;
}

void check_keys(lua_State* L, int table, const std::vector<std::string>& known) {
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING) continue;
    const std::string key = lua_tostring(L, -2);
    bool found = false;
    for (const std::string& name : known) found |= name == key;
    if (!found) throw std::runtime_error("unknown key '" + key + "'" + did_you_mean(key, known));
  }
}

/// Rejects keys that are only for parameters of other types.
void refuse_keys(lua_State* L, int table, const std::string& what, std::initializer_list<const char*> keys) {
  for (const char* const key : keys) {
    const int type = raw_field(L, table, key);
    lua_pop(L, 1);
    if (type != LUA_TNIL) throw std::runtime_error(what + ": unexpected key '" + key + "'");
  }
}

void push_value(lua_State* L, const ParameterValue& value) {
  if (const auto* real = std::get_if<double>(&value)) lua_pushnumber(L, *real);
  if (const auto* whole = std::get_if<int>(&value)) lua_pushinteger(L, *whole);
  if (const auto* yes = std::get_if<bool>(&value)) lua_pushboolean(L, *yes ? 1 : 0);
  if (const auto* text = std::get_if<std::string>(&value)) lua_pushlstring(L, text->data(), text->size());
}

/// Files, the command line and graphs must be able to contain the text.
void require_printable(const std::string& text, const std::string& what) {
  const bool is_control =
      std::any_of(text.begin(), text.end(), [](unsigned char letter) { return letter < ' ' || letter == 0x7F; });
  if (is_control || !is_utf8(text))
    throw std::runtime_error(what + ": expected printable UTF-8 text without line breaks");
}

}  // namespace

/// Runs a member function; a std::exception becomes a Lua error whose message includes the position.
template <int (Declarations::*Method)(lua_State*)>
int Declarations::bound(lua_State* L) {
  auto& self = *static_cast<Declarations*>(lua_touserdata(L, lua_upvalueindex(1)));
  int results = -1;
  try {
    if (self.closed_) throw std::runtime_error("declarations are only allowed while a script is loaded");
    results = (self.*Method)(L);
  } catch (const std::exception& error) {
    const std::string text = error.what();
    const bool has_place = read_fault(text, "").line > 0;
    const std::string message = has_place ? text : at(place_of(L, 1), text);
    lua_pushlstring(L, message.data(), message.size());
  }
  return results >= 0 ? results : lua_error(L);
}

template <int (Declarations::*Method)(lua_State*)>
void Declarations::add(const char* name) {
  lua_pushlightuserdata(lua_, this);
  lua_pushcclosure(lua_, &Declarations::bound<Method>, 1);
  lua_setglobal(lua_, name);
}

Declarations::Declarations(lua_State* L, bool is_scenario, std::vector<std::string> body_parts, PlacesOf places_of,
                           Preview preview)
    : lua_(L),
      is_scenario_(is_scenario),
      body_parts_(std::move(body_parts)),
      places_of_(std::move(places_of)),
      preview_(std::move(preview)) {
  add<&Declarations::param>("param");
  if (!is_scenario) add<&Declarations::args>("args");
  add<&Declarations::keep>("keep");
  add<&Declarations::state>("state");
  if (!is_scenario) add<&Declarations::run>("run");
  add<&Declarations::machine>(is_scenario ? "scenario" : "behavior");
}

/// `name`: for messages, such as "param speed".
ParameterDeclaration Declarations::read_parameter_declaration(lua_State* L, const std::string& name) {
  const int table = lua_gettop(L);
  check_keys(L, table, {"range", "unit", "doc", "choices", "integer"});
  ParameterDeclaration declaration;
  declaration.unit = as_line(raw_text(L, table, "unit"));
  declaration.description = as_line(raw_text(L, table, "doc"));
  if (declaration.description.empty()) throw std::runtime_error(name + ": missing description: doc = \"what it is\"");
  const int type = lua_rawgeti(L, table, 1);
  if (type == LUA_TBOOLEAN) {
    declaration.kind = ParameterKind::boolean;
    declaration.default_value = lua_toboolean(L, -1) != 0;
    lua_pop(L, 1);
    refuse_keys(L, table, name + " is true or false", {"range", "choices", "integer"});
    return declaration;
  }
  if (type == LUA_TSTRING) {
    declaration.kind = ParameterKind::choice;
    declaration.default_value = std::string(lua_tostring(L, -1));
    lua_pop(L, 1);
    refuse_keys(L, table, name + " has a string as default, so it is a choice", {"range", "integer"});
    if (raw_field(L, table, "choices") != LUA_TTABLE) throw std::runtime_error(name + ": missing choices = { ... }");
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
    for (lua_Integer i = 1; i <= count; ++i) {
      if (lua_rawgeti(L, -1, i) != LUA_TSTRING) throw std::runtime_error(name + ": choices must be strings");
      declaration.choices.emplace_back(lua_tostring(L, -1));
      lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return declaration;
  }
  if (type != LUA_TNUMBER) throw std::runtime_error(name + ": missing default as first element: { 0.5, range = ... }");
  const double number = lua_tonumber(L, -1);
  lua_pop(L, 1);
  refuse_keys(L, table, name + " is a number", {"choices"});
  raw_field(L, table, "integer");
  const bool whole = lua_toboolean(L, -1) != 0;
  lua_pop(L, 1);
  if (raw_field(L, table, "range") != LUA_TTABLE)
    throw std::runtime_error(name + ": missing range = { minimum, maximum }");
  if (lua_rawlen(L, -1) != 2) throw std::runtime_error(name + ": expected range = { minimum, maximum }");
  declaration.minimum = raw_number(L, lua_gettop(L), 1, "range");
  declaration.maximum = raw_number(L, lua_gettop(L), 2, "range");
  lua_pop(L, 1);
  if (declaration.minimum > declaration.maximum) throw std::runtime_error(name + ": range is empty");
  constexpr double kMostWhole = std::numeric_limits<int>::max();
  if (whole &&
      (std::abs(number) > kMostWhole || declaration.maximum > kMostWhole || declaration.minimum < -kMostWhole)) {
    throw std::runtime_error(name + ": range is too large for a whole number");
  }
  if (whole) {
    if (number != std::floor(number)) throw std::runtime_error(name + ": expected a whole number as default");
    declaration.kind = ParameterKind::integer;
    declaration.default_value = static_cast<int>(number);
  } else {
    declaration.default_value = number;
  }
  return declaration;
}

void Declarations::note(const std::string& file, std::vector<DeclarationError> errors) {
  std::stable_sort(errors.begin(), errors.end(),
                   [](const auto& left, const auto& right) { return is_before(left.position, right.position); });
  for (const DeclarationError& error : errors)
    faults.push_back(
        {error.file.empty() ? file : error.file, error.position.line, error.message, {}, error.position.column});
}

void Declarations::read_parameter(lua_State* L, const Source& source) {
  const std::string key = lua_tostring(L, -2);
  const std::string word = source.word;
  const std::string what = word + " " + key;
  if (!is_name(key))
    throw std::runtime_error("invalid name of " + std::string(source.is_argument ? "an argument" : "a param") + " '" +
                             key + "' (expected letters, digits and _)");
  if (lua_type(L, -1) != LUA_TTABLE)
    throw std::runtime_error(what + ": expected a table { default, range = { 0, 1 }, doc = \"...\" }");
  DeclaredParameter parameter;
  parameter.key = key;
  parameter.is_argument = source.is_argument;
  parameter.declaration = read_parameter_declaration(L, what);
  parameter.declaration.name = source.prefix + "." + key;
  require_printable(source.prefix, "the name of a script with parameters");
  for (const std::string& choice : parameter.declaration.choices)
    require_printable(choice, std::string("a choice of ").append(what));
  parse_parameter(parameter.declaration,
                  to_text(parameter.declaration.default_value));  // the default must lie within the range
  for (const DeclaredParameter& other : parameters) {
    if (other.declaration.name == parameter.declaration.name) {
      throw std::runtime_error(std::string(what).append(" is declared twice"));
    }
    if (other.key == key && other.is_argument != parameter.is_argument)
      throw std::runtime_error(std::string(what).append(": the script has a param and an argument of this name"));
  }
  parameters.push_back(std::move(parameter));
}

int Declarations::param(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  const Place place = place_of(L, 1);
  return read_parameters(L, {"param", place.file, place.line, stem_of(place.file), false});
}

/// Of the script's own file: its caller sees one list.
int Declarations::args(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  const Place place = place_of(L, 1);
  const bool is_second =
      std::any_of(parameters.begin(), parameters.end(), [](const auto& it) { return it.is_argument; });
  if (is_second) throw std::runtime_error("args is declared twice (expected one list)");
  if (!place.file.starts_with("behaviors/"))
    throw std::runtime_error("args: expected in the file of a behavior, found in " + place.file);
  return read_parameters(L, {"args", place.file, place.line, "args", true});
}

/// Leaves the table of the values on the stack.
int Declarations::read_parameters(lua_State* L, const Source& source) {
  lua_settop(L, 1);
  const std::size_t first = parameters.size();
  std::vector<DeclarationError> errors;
  for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING) {
      throw std::runtime_error(source.is_argument ? "expected named args: args { name = { ... } }"
                                                  : "expected named params: param { name = { ... } }");
    }
    const int key = lua_gettop(L) - 1;
    try {
      read_parameter(L, source);
    } catch (const std::runtime_error& error) {
      refused_.push_back(std::string(source.prefix).append(".").append(lua_tostring(L, key)));
      const TextPosition from{source.line, 0};
      constexpr TextPosition kEnd{std::numeric_limits<int>::max(), 0};
      errors.push_back({places_of_(source.file).key(lua_tostring(L, key), from, kEnd).value_or(from), error.what()});
      lua_settop(L, key + 1);
    }
  }
  note(source.file, std::move(errors));
  // The order of Lua's tables differs from process to process, and functions of arguments are called in this order.
  std::sort(parameters.begin() + static_cast<std::ptrdiff_t>(first), parameters.end(),
            [](const DeclaredParameter& left, const DeclaredParameter& right) { return left.key < right.key; });
  lua_newtable(L);
  for (std::size_t i = first; i < parameters.size(); ++i) {
    lua_pushvalue(L, -1);
    parameters[i].values = luaL_ref(L, LUA_REGISTRYINDEX);
    set_value(parameters[i],
              source.is_argument ? parameters[i].declaration.default_value : preview_(parameters[i].declaration));
  }
  make_read_only(L, source.is_argument ? "args" : "param " + source.prefix);
  return 1;
}

void Declarations::set_value(DeclaredParameter& parameter, const ParameterValue& value) {
  if (const auto* real = std::get_if<double>(&value)) parameter.number = *real;
  if (const auto* whole = std::get_if<int>(&value)) parameter.number = *whole;
  lua_rawgeti(lua_, LUA_REGISTRYINDEX, parameter.values);
  lua_pushlstring(lua_, parameter.key.data(), parameter.key.size());
  push_value(lua_, value);
  lua_rawset(lua_, -3);
  lua_pop(lua_, 1);
}

int Declarations::keep(lua_State* L) {
  constexpr std::size_t kMost = 100;  // each is read again at a reload, even if many are the same table
  if (memories.size() >= kMost) throw std::runtime_error("too many keep { } (expected at most 100)");
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 1);
  const std::string file = place_of(L, 1).file;
  int ordinal = 1;
  for (const KeptMemory& other : memories) ordinal += other.name.starts_with(file + "#") ? 1 : 0;
  lua_pushvalue(L, 1);
  memories.push_back({file + "#" + std::to_string(ordinal), luaL_ref(L, LUA_REGISTRYINDEX)});
  return 1;
}

template <int (Declarations::*Body)(lua_State*)>
int Declarations::await_table(lua_State* L) {
  lua_pushlightuserdata(L, this);
  lua_pushvalue(L, 1);
  const Place place = place_of(L, 1);
  lua_pushinteger(L, place.line);
  lua_pushlstring(L, place.file.data(), place.file.size());
  lua_pushcclosure(L, &Declarations::bound<Body>, 4);
  return 1;
}

int Declarations::state(lua_State* L) {
  const std::string name = luaL_checkstring(L, 1);
  if (name.empty() || name.find('/') != std::string::npos)
    throw std::runtime_error("state: expected a name without '/'");
  require_printable(name, "the name of a state");
  return await_table<&Declarations::state_body>(L);
}

int Declarations::state_body(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  mark(L, 1, Marked::state, {lua_upvalueindex(2), lua_upvalueindex(3), lua_upvalueindex(4)});
  lua_settop(L, 1);
  return 1;
}

int Declarations::run(lua_State* L) {
  const std::string name = luaL_checkstring(L, 1);
  if (!is_name(name)) throw std::runtime_error("run: expected the name of a behavior, found '" + name + "'");
  return await_table<&Declarations::run_body>(L);
}

int Declarations::run_body(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  mark(L, 1, Marked::call, {lua_upvalueindex(2), lua_upvalueindex(3), lua_upvalueindex(4)});
  lua_settop(L, 1);
  return 1;
}

int Declarations::machine(lua_State* L) {
  const std::string name = luaL_checkstring(L, 1);
  if (!is_name(name)) throw std::runtime_error("invalid name '" + name + "' (expected letters, digits and _)");
  lua_pushlightuserdata(L, this);
  lua_pushvalue(L, 1);
  lua_pushinteger(L, place_of(L, 1).line);
  lua_pushcclosure(L, &Declarations::bound<&Declarations::machine_body>, 3);
  return 1;
}

int Declarations::machine_body(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 1);
  MachineDefinition definition;
  definition.name = lua_tostring(L, lua_upvalueindex(2));
  definition.file = place_of(L, 1).file;
  definition.is_scenario = is_scenario_;
  for (const MachineDefinition& other : machines) {
    if (other.name == definition.name) throw std::runtime_error("'" + definition.name + "' is declared twice");
  }
  std::vector<std::string> names;
  for (const DeclaredParameter& parameter : parameters) names.push_back(parameter.declaration.name);
  names.insert(names.end(), refused_.begin(), refused_.end());  // so that their use is not an error, too
  std::vector<DeclarationError> errors;
  MachineReader(L, definition, names, body_parts_, places_of_, errors)
      .read(1, static_cast<int>(lua_tointeger(L, lua_upvalueindex(3))));
  for (DeclarationError& error : resolve(definition)) errors.push_back(std::move(error));
  note(definition.file, std::move(errors));
  machines.push_back(std::move(definition));
  return 0;
}

}  // namespace reorient

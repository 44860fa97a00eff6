// SPDX-License-Identifier: MIT
#include "engine/script/language/lua_fields.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <stdexcept>

#include "engine/parameters/nearest_name.h"
#include "engine/script/language/world_tables.h"

namespace reorient {
namespace {

/// Where the next field begins.
struct FieldPlace {
  std::size_t number = 0, text = 0;
};

/// An integer of Lua where a double represents it exactly.
void push_number(lua_State* L, double number, FieldType type) {
  constexpr double kExact = 9007199254740992.0;  // 2^53
  if (type == FieldType::integer && std::abs(number) <= kExact) {
    lua_pushinteger(L, static_cast<lua_Integer>(number));
  } else {
    lua_pushnumber(L, number);
  }
}

void push_field(lua_State* L, const DeclaredField& field, const FieldData& data, FieldPlace& place,
                const std::string& what) {
  switch (field.type) {
    case FieldType::boolean:
      lua_pushboolean(L, data.numbers.at(place.number++) != 0.0 ? 1 : 0);
      return;
    case FieldType::text: {
      const std::string& text = data.texts.at(place.text++);
      lua_pushlstring(L, text.data(), text.size());
      return;
    }
    case FieldType::number:
    case FieldType::integer:
      push_number(L, data.numbers.at(place.number++), field.type);
      return;
    case FieldType::point:
    case FieldType::pose:
      lua_createtable(L, 0, 3);
      for (std::size_t i = 0; i < numbers_of(field.type); ++i) {
        lua_pushnumber(L, data.numbers.at(place.number++));
        lua_setfield(L, -2, kCoordinates[i]);
      }
      make_read_only(L, what);
      return;
  }
}

[[noreturn]] void refuse(const std::string& what, const std::string& expected, lua_State* L, int index) {
  throw std::runtime_error(what + ": expected " + expected + ", found " +
                           (lua_isnil(L, index) ? "nothing" : std::string("a ") + luaL_typename(L, index)));
}

double read_number(lua_State* L, int index, const std::string& what) {
  if (lua_type(L, index) != LUA_TNUMBER) refuse(what, "a number", L, index);
  return lua_tonumber(L, index);
}

/// Throws if the table has a key that is no name of a field.
void require_known_keys(lua_State* L, int table, std::span<const std::string> known, const std::string& what) {
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING)
      throw std::runtime_error(what + ": expected names of fields, found a " + luaL_typename(L, -2) + " as a key");
    const std::string key = lua_tostring(L, -2);
    bool is_known = false;
    for (const std::string& name : known) is_known |= name == key;
    if (!is_known)
      throw std::runtime_error(std::string(what).append(": unknown field '").append(key).append("'") +
                               did_you_mean(key, known));
  }
}

/// Appends the value at `index`, which is absolute.
void read_field(lua_State* L, int index, const DeclaredField& field, FieldData& data, const std::string& what) {
  switch (field.type) {
    case FieldType::boolean:
      if (!lua_isboolean(L, index)) refuse(what, "true or false", L, index);
      data.numbers.push_back(lua_toboolean(L, index));
      return;
    case FieldType::text: {
      if (lua_type(L, index) != LUA_TSTRING) refuse(what, "a text", L, index);
      std::size_t length = 0;
      const char* const text = lua_tolstring(L, index, &length);
      data.texts.emplace_back(text, length);
      return;
    }
    case FieldType::number:
    case FieldType::integer:
      data.numbers.push_back(read_number(L, index, what));
      return;
    case FieldType::point:
    case FieldType::pose:
      if (!lua_istable(L, index))
        refuse(what, field.type == FieldType::point ? "{ x = ..., y = ... }" : "{ x = ..., y = ..., rotation = ... }",
               L, index);
      for (std::size_t i = 0; i < numbers_of(field.type); ++i) {
        lua_getfield(L, index, kCoordinates[i]);
        data.numbers.push_back(read_number(L, -1, what + "." + kCoordinates[i]));
        lua_pop(L, 1);
      }
      return;
  }
}

void require_fit(const FieldData& data, const std::vector<DeclaredField>& fields, const std::string& what) {
  if (const std::string mistake = mistake_in(data, fields); !mistake.empty())
    throw std::runtime_error(what + ": " + mistake);
}

}  // namespace

void push_content(lua_State* L, const DeclaredValue& value, const FieldData& data, std::uint32_t records,
                  const std::string& what) {
  FieldPlace place;
  if (!value.is_list()) return push_field(L, value.fields.front(), data, place, what);
  lua_createtable(L, static_cast<int>(records), 0);
  for (std::uint32_t i = 1; i <= records; ++i) {
    const std::string record = what + "[" + std::to_string(i) + "]";
    lua_createtable(L, 0, static_cast<int>(value.fields.size()));
    for (const DeclaredField& field : value.fields) {
      push_field(L, field, data, place, record + "." + field.name);
      lua_setfield(L, -2, field.name.c_str());
    }
    make_read_only(L, record);
    lua_rawseti(L, -2, i);
  }
  make_read_only_list(L, what);
}

void push_argument(lua_State* L, const std::vector<DeclaredField>& fields, const FieldData& data,
                   const std::string& name, const std::string& what) {
  FieldPlace place;
  std::vector<std::string> known;
  for (const DeclaredField& field : fields) {
    if (field.name == name) return push_field(L, field, data, place, std::string(what).append(".").append(name));
    place.number += numbers_of(field.type);
    place.text += texts_of(field.type);
    known.push_back(field.name);
  }
  throw std::runtime_error(what + " has no argument '" + name + "'" + did_you_mean(name, known));
}

std::uint16_t action_named(const ApplicationInterface& declared, std::string_view name) {
  std::vector<std::string> known;
  for (const DeclaredAction& action : declared.actions) {
    if (action.name == name) return static_cast<std::uint16_t>(known.size());
    known.push_back(action.name);
  }
  throw std::runtime_error("unknown action '" + std::string(name) + "'" + did_you_mean(name, known));
}

ActionReport report_of(std::uint32_t id, std::string_view state, std::string_view reason) {
  if (id == 0) throw std::runtime_error("expected a report about an action that was requested");
  for (const ActionState known : {ActionState::running, ActionState::done, ActionState::failed}) {
    if (to_string(known) == state) return {id, known, std::string(reason.substr(0, kLongestFieldText))};
  }
  throw std::runtime_error("expected a report of running, done or failed, found '" + std::string(state) + "'");
}

FieldData read_record(lua_State* L, int index, const std::vector<DeclaredField>& fields, const std::string& what) {
  const int table = lua_absindex(L, index);
  const bool has_table = !lua_isnoneornil(L, table);
  if (has_table && !lua_istable(L, table)) refuse(what, "a table with the names of the fields", L, table);
  if (has_table) {
    std::vector<std::string> names;
    names.reserve(fields.size());
    for (const DeclaredField& field : fields) names.push_back(field.name);
    require_known_keys(L, table, names, what);
  }
  FieldData data;
  for (const DeclaredField& field : fields) {
    if (has_table) {
      lua_getfield(L, table, field.name.c_str());
    } else {
      lua_pushnil(L);
    }
    const std::string name = what + ": " + field.name;
    if (!lua_isnil(L, -1)) {
      read_field(L, lua_gettop(L), field, data, name);
    } else if (field.is_required) {
      throw std::runtime_error(name + ": expected a value, found nothing");
    } else {
      append(data, field.initial);
    }
    lua_pop(L, 1);
  }
  require_fit(data, fields, what);
  return data;
}

std::vector<SetValue> read_inputs(lua_State* L, int index, const ApplicationInterface& declared) {
  const int table = lua_absindex(L, index);
  if (!lua_istable(L, table)) refuse("input", "a table of values, as in { ball = { x = 1.0 } }", L, table);
  std::vector<std::string> known;
  for (const DeclaredValue& value : declared.values) known.push_back(value.name);
  std::vector<SetValue> all;
  const auto read_known = [&](const std::string& name) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) return false;
    all.push_back(read_content(L, -1, declared, static_cast<std::uint16_t>(found - known.begin())));
    return true;
  };
  const auto key_at = [&](const std::string& of) {
    if (lua_type(L, -2) != LUA_TSTRING)
      throw std::runtime_error(of + ": expected names of values, found a " + luaL_typename(L, -2) + " as a key");
    return std::string(lua_tostring(L, -2));
  };
  const auto refuse_name = [&](const std::string& name) {
    throw std::runtime_error("input has no value '" + name + "'" + did_you_mean(name, known));
  };
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
    const std::string name = key_at("input");
    if (read_known(name)) continue;
    if (!lua_istable(L, -1)) refuse_name(name);
    const int group = lua_gettop(L);
    for (lua_pushnil(L); lua_next(L, group) != 0; lua_pop(L, 1)) {
      const std::string member = name + "." + key_at(name);
      if (!read_known(member)) refuse_name(member);
    }
  }
  return all;
}

SetValue read_content(lua_State* L, int index, const ApplicationInterface& declared, std::uint16_t value) {
  const DeclaredValue& known = declared.values.at(value);
  SetValue set{value, 1, {}};
  const int place = lua_absindex(L, index);
  if (!known.is_list()) {
    read_field(L, place, known.fields.front(), set.data, known.name);
    require_fit(set.data, known.fields, known.name);
    return set;
  }
  if (!lua_istable(L, place)) refuse(known.name, "a list of records", L, place);
  const lua_Integer count = luaL_len(L, place);
  if (count < 0 || count > known.most)
    throw std::runtime_error(known.name + ": expected at most " + std::to_string(known.most) + " records, found " +
                             std::to_string(count));
  set.records = static_cast<std::uint32_t>(count);
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_geti(L, place, i);
    append(set.data, read_record(L, -1, known.fields, known.name + "[" + std::to_string(i) + "]"));
    lua_pop(L, 1);
  }
  return set;
}

}  // namespace reorient

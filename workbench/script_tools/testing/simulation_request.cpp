// SPDX-License-Identifier: MIT
#include "workbench/script_tools/testing/simulation_request.h"

#include <algorithm>
#include <stdexcept>

#include "engine/parameters/nearest_name.h"
#include "engine/script/sandbox/safe_library.h"
#include "engine/script/sandbox/sandbox.h"
#include "geometry/image.h"

namespace reorient {
namespace {

constexpr double kLongestSimulation = 86400.0;  // s

/// The value on top of the stack, if it is a whole number within the bounds.
std::optional<lua_Integer> whole_number(lua_State* L, lua_Integer least, lua_Integer most) {
  if (lua_isinteger(L, -1) == 0) return std::nullopt;
  const lua_Integer number = lua_tointeger(L, -1);
  return number >= least && number <= most ? std::optional(number) : std::nullopt;
}

/// The text at the stack index. The script pays for it because a table may contain the same text many times.
std::string take_text(lua_State* L, int index) {
  constexpr std::int64_t kPriceOfAText = 100;
  Sandbox::of(L).charge(kPriceOfAText + static_cast<std::int64_t>(lua_rawlen(L, index)));
  return lua_tostring(L, index);
}

bool read_width(lua_State* L, SimulationRequest& request) {
  const std::optional<lua_Integer> width = whole_number(L, kImageWidths.front(), kImageWidths.back());
  if (!width || std::find(kImageWidths.begin(), kImageWidths.end(), *width) == kImageWidths.end()) return false;
  request.width = static_cast<int>(*width);
  return true;
}

bool read_seconds(lua_State* L, SimulationRequest& request) {
  if (lua_type(L, -1) != LUA_TNUMBER) return false;
  request.seconds = lua_tonumber(L, -1);
  return request.seconds > 0.0 && request.seconds <= kLongestSimulation;
}

bool read_seed(lua_State* L, SimulationRequest& request) {
  const std::optional<lua_Integer> seed = whole_number(L, 0, LUA_MAXINTEGER);
  if (seed) request.seed = static_cast<std::uint64_t>(*seed);
  return seed.has_value();
}

bool read_with(lua_State* L, SimulationRequest& request) {
  if (!lua_istable(L, -1)) return false;
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
  for (lua_Integer i = 1; i <= count; ++i) {
    const bool is_text = lua_rawgeti(L, -1, i) == LUA_TSTRING;
    if (is_text) request.with.push_back(take_text(L, -1));
    lua_pop(L, 1);
    if (!is_text) return false;
  }
  return true;
}

bool read_parameters(lua_State* L, SimulationRequest& request) {
  if (!lua_istable(L, -1)) return false;
  const int table = lua_gettop(L);
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING) {
      lua_pop(L, 2);
      return false;
    }
    push_text(L, -1);
    request.parameters.emplace_back(take_text(L, -3), take_text(L, -1));
    lua_pop(L, 1);
  }
  return true;
}

bool read_scenario(lua_State* L, SimulationRequest& request) {
  if (lua_type(L, -1) != LUA_TSTRING) return false;
  request.scenario = lua_tostring(L, -1);
  return true;
}

bool read_room(lua_State* L, SimulationRequest& request) {
  if (lua_type(L, -1) != LUA_TSTRING) return false;
  request.room = lua_tostring(L, -1);
  return !request.room.empty();
}

bool read_hall_seed(lua_State* L, SimulationRequest& request) {
  const std::optional<lua_Integer> seed = whole_number(L, 0, LUA_MAXINTEGER);
  if (seed) request.hall_seed = static_cast<std::uint64_t>(*seed);
  return seed.has_value();
}

bool read_field_file(lua_State* L, SimulationRequest& request) {
  if (lua_type(L, -1) != LUA_TSTRING) return false;
  request.field = lua_tostring(L, -1);
  return !request.field.empty();
}

bool read_room_awareness(lua_State* L, SimulationRequest& request) {
  if (!lua_isboolean(L, -1)) return false;
  request.room_awareness = lua_toboolean(L, -1) != 0;
  return true;
}

/// A key of the table. `read` reads the value on top of the stack and leaves it there; it returns false if the value is
/// invalid.
struct Field {
  const char* name;
  bool (*read)(lua_State* L, SimulationRequest& request);
  const char* expected;
};
constexpr Field kFields[] = {{"scenario", read_scenario, "the name of a scenario"},
                             {"with", read_with, "a list of names of behaviors"},
                             {"seed", read_seed, "a non-negative whole number"},
                             {"width", read_width, "160, 320, 544 or 640 pixels"},
                             {"seconds", read_seconds, "a positive number up to 86400"},
                             {"room_awareness", read_room_awareness, "true or false"},
                             {"room", read_room, "the name or path of a room"},
                             {"hall_seed", read_hall_seed, "a non-negative whole number"},
                             {"field", read_field_file, "the name or path of a field"},
                             {"params", read_parameters, "a table of parameter names and values"}};

void read_field(lua_State* L, const std::string& key, SimulationRequest& request) {
  std::vector<std::string> known;
  for (const Field& field : kFields) {
    known.emplace_back(field.name);
    if (field.name != key) continue;
    if (field.read(L, request)) return;
    throw std::runtime_error("simulate: " + key + ": expected " + field.expected);
  }
  throw std::runtime_error("simulate: unknown key '" + key + "'" + did_you_mean(key, known));
}

}  // namespace

SimulationRequest read_simulation_request(lua_State* L, int table) {
  luaL_checktype(L, table, LUA_TTABLE);
  SimulationRequest request;
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING)
      throw std::runtime_error("simulate: expected names as keys, as in simulate { scenario = \"...\", seed = 1 }");
    read_field(L, lua_tostring(L, -2), request);
  }
  if (request.scenario.empty())
    throw std::runtime_error("simulate: missing scenario, as in simulate { scenario = \"mirrored_placement\" }");
  if (request.hall_seed && !request.room.empty())
    throw std::runtime_error("simulate: expected room or hall_seed, found both");
  return request;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "engine/script/sandbox/safe_library.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "engine/script/sandbox/sandbox.h"

namespace reorient {
namespace {

/// A script can catch its own errors, but not the end of its budget.
int safe_pcall(lua_State* L) {
  luaL_checkany(L, 1);
  lua_pushcfunction(L, &Sandbox::pay_for_error);
  lua_insert(L, 1);
  const int status = lua_pcall(L, lua_gettop(L) - 2, LUA_MULTRET, 1);
  Sandbox::of(L).raise_if_exhausted();
  lua_pushboolean(L, status == LUA_OK ? 1 : 0);
  lua_replace(L, 1);
  return lua_gettop(L);
}

/// The handler runs after the stack was unwound, as a normal call.
int safe_xpcall(lua_State* L) {
  luaL_checktype(L, 2, LUA_TFUNCTION);
  const int arguments = lua_gettop(L) - 2;
  lua_pushvalue(L, 1);
  lua_insert(L, 3);
  lua_pushcfunction(L, &Sandbox::pay_for_error);
  lua_replace(L, 1);
  const int status = lua_pcall(L, arguments, LUA_MULTRET, 1);
  Sandbox::of(L).raise_if_exhausted();
  if (status == LUA_OK) {
    lua_pushboolean(L, 1);
    lua_replace(L, 2);
    return lua_gettop(L) - 1;
  }
  lua_pushvalue(L, 2);
  lua_insert(L, -2);
  lua_pushboolean(L, 0);
  lua_insert(L, -3);
  lua_call(L, 1, 1);
  return 2;
}

bool has_field(lua_State* L, int table, const char* name) {
  lua_pushstring(L, name);
  const bool there = lua_rawget(L, table) != LUA_TNIL;
  lua_pop(L, 1);
  return there;
}

bool is_protected(lua_State* L, int index) {
  if (luaL_getmetafield(L, index, "__metatable") == LUA_TNIL) return false;
  lua_pop(L, 1);
  return true;
}

int safe_setmetatable(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  if (!lua_isnil(L, 2)) luaL_checktype(L, 2, LUA_TTABLE);
  if (is_protected(L, 1)) return luaL_error(L, "metatable of this table is protected");
  lua_settop(L, 2);
  if (lua_istable(L, 2) && has_field(L, 2, "__gc")) {
    return luaL_error(L, "metatable: __gc is not allowed in scripts");
  }
  if (lua_istable(L, 2)) Sandbox::of(L).metatables().admit(L, 2);
  lua_setmetatable(L, 1);
  return 1;
}

int safe_rawset(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  luaL_checkany(L, 3);
  if (is_protected(L, 1)) return luaL_error(L, "table is read-only");
  lua_settop(L, 3);
  lua_rawset(L, 1);
  return 1;
}

int safe_tostring(lua_State* L) {
  constexpr std::int64_t kPriceOfDigits = 50;
  luaL_checkany(L, 1);
  if (lua_type(L, 1) == LUA_TNUMBER) Sandbox::of(L).charge(kPriceOfDigits);
  push_text(L, 1);
  return 1;
}

/// The sort key of the iteration of tables, which gives the same order on every computer and in every run.
struct Key {
  int type = LUA_TNIL;
  double number = 0.0;    ///< of a boolean: 0 or 1
  lua_Integer whole = 0;  ///< of whole numbers, because a double cannot represent all of them
  std::string_view text;
  lua_Integer place = 0;  ///< in the table's own order

  bool operator<(const Key& other) const {
    return std::tie(type, number, whole, text) < std::tie(other.type, other.number, other.whole, other.text);
  }
};

/// The key on top of the stack, for messages of `function`.
Key read_key(lua_State* L, const char* function) {
  Key key;
  key.type = lua_type(L, -1);
  if (key.type == LUA_TBOOLEAN) {
    key.number = lua_toboolean(L, -1);
  } else if (key.type == LUA_TNUMBER) {
    key.number = lua_tonumber(L, -1);
    if (lua_isinteger(L, -1) != 0) key.whole = lua_tointeger(L, -1);
  } else if (key.type == LUA_TSTRING) {
    std::size_t length = 0;
    const char* const text = lua_tolstring(L, -1, &length);
    key.text = {text, length};
  } else {
    luaL_error(L, "%s: a key of type %s has no reproducible order (expected numbers or strings)", function,
               luaL_typename(L, -1));
  }
  return key;
}

/// Upvalues: the table, its keys in order, the index of the previous key.
int next_pair(lua_State* L) {
  for (;;) {
    const lua_Integer index = lua_tointeger(L, lua_upvalueindex(3)) + 1;
    lua_pushinteger(L, index);
    lua_replace(L, lua_upvalueindex(3));
    if (lua_rawgeti(L, lua_upvalueindex(2), index) == LUA_TNIL) return 1;
    lua_pushvalue(L, -1);
    if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) return 2;
    lua_pop(L, 2);  // removed during the iteration
  }
}

int safe_pairs(lua_State* L) {
  luaL_checkany(L, 1);
  if (luaL_getmetafield(L, 1, "__pairs") != LUA_TNIL) {
    lua_pushvalue(L, 1);
    lua_call(L, 1, 3);
    return 3;
  }
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 1);
  lua_newtable(L);  // the keys in the table's own order; prevents the collection of their strings
  std::vector<Key> keys;
  Sandbox::of(L).charge_walk();
  for (lua_pushnil(L); lua_next(L, 1) != 0;) {
    lua_pop(L, 1);
    Key key = read_key(L, "pairs");
    key.place = static_cast<lua_Integer>(keys.size()) + 1;
    keys.push_back(key);
    lua_pushvalue(L, -1);
    lua_rawseti(L, 2, key.place);
  }
  const auto count = static_cast<std::int64_t>(keys.size());
  Sandbox::of(L).charge(count * static_cast<std::int64_t>(std::bit_width(keys.size())));
  std::sort(keys.begin(), keys.end());
  lua_pushvalue(L, 1);
  lua_createtable(L, static_cast<int>(keys.size()), 0);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    lua_rawgeti(L, 2, keys[i].place);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  lua_pushinteger(L, 0);
  lua_pushcclosure(L, next_pair, 3);
  return 1;
}

/// The first pair of a table after a key, in the order of pairs. Each call reads all keys: `next(t) == nil` is cheap
/// enough, and a loop over a large table should use pairs.
int safe_next(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  if (luaL_getmetafield(L, 1, "__pairs") != LUA_TNIL)
    return luaL_error(L, "next: this table has __pairs (expected a plain table; write pairs)");
  lua_settop(L, 2);
  std::optional<Key> after, first;
  if (!lua_isnil(L, 2)) after = read_key(L, "next");
  lua_pushnil(L);  // at 3: the first of the later keys
  std::int64_t count = 0;
  Sandbox::of(L).charge_walk();
  for (lua_pushnil(L); lua_next(L, 1) != 0; ++count) {
    lua_pop(L, 1);
    const Key key = read_key(L, "next");
    if ((after && !(*after < key)) || (first && !(key < *first))) continue;
    first = key;
    lua_copy(L, -1, 3);
  }
  Sandbox::of(L).charge(count);
  if (!first) return 1;
  lua_pushvalue(L, 3);
  lua_rawget(L, 1);
  return 2;
}

/// Upvalue: the name of the operator. Lua converts texts that look like numbers. In scripts a text in arithmetic is an
/// error, since it is more often a mistake, unless the other operand is a table that knows the operator.
int refuse_arithmetic(lua_State* L) {
  if (lua_type(L, 2) == LUA_TTABLE && luaL_getmetafield(L, 2, lua_tostring(L, lua_upvalueindex(1))) != LUA_TNIL) {
    lua_insert(L, 1);
    lua_call(L, 2, 1);
    return 1;
  }
  const int text = lua_type(L, 1) == LUA_TSTRING ? 1 : 2;
  return luaL_error(L,
                    "attempt to perform arithmetic on the string value '%s' (expected a number; write tonumber(...))",
                    lua_tostring(L, text));
}

/// Table functions are C loops over the table's length: they accept plain tables only, whose
/// length no metamethod can change, and are charged in advance.
std::int64_t plain_length(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  if (lua_getmetatable(L, 1) != 0) luaL_argerror(L, 1, "a plain table expected, without a metatable");
  return static_cast<std::int64_t>(lua_rawlen(L, 1));
}

int call_original(lua_State* L) {
  const int arguments = lua_gettop(L);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, arguments, LUA_MULTRET);
  return lua_gettop(L);
}

/// Limits the results, which can become arguments: a single instruction would copy thousands of values.
int few_results(lua_State* L) {
  constexpr int kMostResults = 250;
  const int results = call_original(L);
  if (results > kMostResults) return luaL_error(L, "too many results (expected at most %d)", kMostResults);
  return results;
}

int paid_by_length(lua_State* L) {
  Sandbox::of(L).charge(plain_length(L));
  return call_original(L);
}

int paid_by_sorting(lua_State* L) {
  const std::int64_t length = plain_length(L);
  const auto levels = static_cast<std::int64_t>(std::bit_width(static_cast<std::uint64_t>(length)));
  const std::int64_t each = levels * Sandbox::of(L).price_of_instruction();  // a comparison is what an instruction does
  Sandbox::of(L).charge(length < (std::int64_t{1} << 40) ? length * each : length);
  return call_original(L);
}

/// `first`: position of the first index among the arguments; the last index follows it.
void charge_range(lua_State* L, int first, std::int64_t length) {
  const lua_Integer from = luaL_optinteger(L, first, 1);
  const lua_Integer to = luaL_optinteger(L, first + 1, length);
  if (to < from) return;
  const auto count = static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from);
  Sandbox::of(L).charge(static_cast<std::int64_t>(std::min<std::uint64_t>(count, std::uint64_t{1} << 62)));
}

int paid_concat(lua_State* L) {
  charge_range(L, 3, plain_length(L));
  return call_original(L);
}

int paid_unpack(lua_State* L) {
  charge_range(L, 2, plain_length(L));
  return few_results(L);
}

/// The cost of reading a number grows with the length of the text.
int paid_tonumber(lua_State* L) {
  if (lua_type(L, 1) == LUA_TSTRING) Sandbox::of(L).charge(static_cast<std::int64_t>(lua_rawlen(L, 1)));
  return call_original(L);
}

int paid_move(lua_State* L) {
  const std::int64_t length = plain_length(L);
  const bool other_is_forged = lua_istable(L, 5) && lua_getmetatable(L, 5) != 0;
  if (other_is_forged) luaL_argerror(L, 5, "a plain table expected, without a metatable");
  charge_range(L, 2, length);
  return call_original(L);
}

/// Wraps or copies fields of the library on top of the stack into the table below it; nullptr: unchanged.
struct Borrowed {
  const char* name;
  lua_CFunction wrapper;
};

template <std::size_t Count>
void borrow(lua_State* L, const Borrowed (&functions)[Count]) {
  for (const Borrowed& function : functions) {
    lua_getfield(L, -1, function.name);
    if (function.wrapper != nullptr) lua_pushcclosure(L, function.wrapper, 1);
    lua_setfield(L, -3, function.name);
  }
}

void open_base(lua_State* L) {
  constexpr Borrowed kBase[] = {{"assert", nullptr}, {"error", nullptr},    {"getmetatable", nullptr},
                                {"ipairs", nullptr}, {"rawequal", nullptr}, {"rawget", nullptr},
                                {"rawlen", nullptr}, {"select", nullptr},   {"tonumber", paid_tonumber},
                                {"type", nullptr}};
  constexpr luaL_Reg kOwn[] = {
      {"pcall", safe_pcall},   {"xpcall", safe_xpcall},     {"setmetatable", safe_setmetatable},
      {"rawset", safe_rawset}, {"tostring", safe_tostring}, {"pairs", safe_pairs},
      {"next", safe_next},     {nullptr, nullptr}};
  // luaopen_base fills the globals table itself, so it gets a temporary table.
  lua_newtable(L);
  lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
  lua_newtable(L);
  lua_rawseti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
  luaL_requiref(L, "_G", luaopen_base, 0);
  lua_pushvalue(L, -2);
  lua_rawseti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
  lua_remove(L, -2);
  borrow(L, kBase);
  lua_pop(L, 1);
  luaL_setfuncs(L, kOwn, 0);
}

/// As Lua's own, but from the sandbox's numbers, which are the same in every run and can be saved and restored.
int safe_random(lua_State* L) {
  Random& random = Sandbox::of(L).random();
  const int arguments = lua_gettop(L);
  if (arguments == 0) {
    lua_pushnumber(L, random.uniform());
    return 1;
  }
  if (arguments > 2) return luaL_error(L, "wrong number of arguments");
  const lua_Integer low = arguments == 1 ? 1 : luaL_checkinteger(L, 1);
  const lua_Integer high = luaL_checkinteger(L, arguments);
  if (arguments == 1 && high == 0) {
    lua_pushinteger(L, static_cast<lua_Integer>(random()));
    return 1;
  }
  luaL_argcheck(L, low <= high, arguments, "interval is empty");
  const std::uint64_t range = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
  // The smallest mask that covers the range; larger values are drawn again.
  const std::uint64_t mask = range == 0 ? 0 : ~std::uint64_t{0} >> std::countl_zero(range);
  std::uint64_t drawn = random() & mask;
  while (drawn > range) drawn = random() & mask;
  lua_pushinteger(L, static_cast<lua_Integer>(static_cast<std::uint64_t>(low) + drawn));
  return 1;
}

void open_math(lua_State* L) {
  constexpr Borrowed kMath[] = {
      {"abs", nullptr},  {"acos", nullptr},      {"asin", nullptr}, {"atan", nullptr},       {"ceil", nullptr},
      {"cos", nullptr},  {"deg", nullptr},       {"exp", nullptr},  {"floor", nullptr},      {"fmod", nullptr},
      {"huge", nullptr}, {"log", nullptr},       {"max", nullptr},  {"min", nullptr},        {"modf", nullptr},
      {"pi", nullptr},   {"rad", nullptr},       {"sin", nullptr},  {"sqrt", nullptr},       {"tan", nullptr},
      {"type", nullptr}, {"tointeger", nullptr}, {"ult", nullptr},  {"maxinteger", nullptr}, {"mininteger", nullptr}};
  lua_newtable(L);
  luaL_requiref(L, "math", luaopen_math, 0);
  borrow(L, kMath);
  lua_pop(L, 1);
  lua_pushcfunction(L, safe_random);
  lua_setfield(L, -2, "random");
}

void open_table(lua_State* L) {
  constexpr Borrowed kTable[] = {{"insert", paid_by_length}, {"remove", paid_by_length}, {"sort", paid_by_sorting},
                                 {"concat", paid_concat},    {"unpack", paid_unpack},    {"move", paid_move},
                                 {"pack", nullptr}};
  lua_newtable(L);
  luaL_requiref(L, "table", luaopen_table, 0);
  borrow(L, kTable);
  lua_pop(L, 1);
}

void open_string(lua_State* L) {
  constexpr Borrowed kString[] = {{"byte", few_results}, {"char", nullptr}, {"len", nullptr},  {"lower", nullptr},
                                  {"reverse", nullptr},  {"sub", nullptr},  {"upper", nullptr}};
  lua_newtable(L);
  luaL_requiref(L, "string", luaopen_string, 0);
  borrow(L, kString);
  lua_getfield(L, -1, "format");
  lua_setfield(L, LUA_REGISTRYINDEX, "format");
  lua_pop(L, 1);
  add_safe_strings(L);
  lua_pushliteral(L, "");  // ("text"):upper() finds the safe functions too
  lua_newtable(L);
  lua_pushvalue(L, -3);
  lua_setfield(L, -2, "__index");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  for (const char* operation : {"__add", "__sub", "__mul", "__div", "__idiv", "__mod", "__pow", "__unm"}) {
    lua_pushstring(L, operation);
    lua_pushcclosure(L, refuse_arithmetic, 1);
    lua_setfield(L, -2, operation);
  }
  lua_setmetatable(L, -2);
  lua_pop(L, 1);
}

}  // namespace

void push_text(lua_State* L, int index) {
  const int type = lua_type(L, index);
  const bool has_address = type == LUA_TTABLE || type == LUA_TFUNCTION || type == LUA_TUSERDATA;
  if (has_address && luaL_getmetafield(L, index, "__tostring") == LUA_TNIL) {
    lua_pushstring(L, lua_typename(L, type));
    return;
  }
  if (has_address) lua_pop(L, 1);
  luaL_tolstring(L, index, nullptr);
}

void open_safe_library(lua_State* L) {
  Metatables::open(L);
  open_base(L);
  open_math(L);
  lua_setfield(L, -2, "math");
  open_table(L);
  lua_setfield(L, -2, "table");
  open_string(L);
  lua_setfield(L, -2, "string");
  lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
  for (lua_pushnil(L); lua_next(L, -3) != 0;) {
    lua_pushvalue(L, -2);
    lua_insert(L, -2);
    lua_rawset(L, -4);
  }
  lua_pop(L, 2);
  lua_pushnil(L);
  lua_setfield(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
// The typed layer between C++ and Lua: makes a Lua function that checks its arguments from a member function.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <lua.hpp>

#include "engine/script/sandbox/sandbox.h"

namespace reorient::lua {

/// Reads and writes a C++ type on Lua's stack, and names it for the documentation.
template <typename T>
struct Value;

template <>
struct Value<double> {
  static constexpr std::string_view name = "number";
  static double read(lua_State* L, int index) {
    const double number = luaL_checknumber(L, index);
    if (!std::isfinite(number)) luaL_argerror(L, index, "finite number expected");
    return number;
  }
  static void push(lua_State* L, double number) { lua_pushnumber(L, number); }
};

template <>
struct Value<std::int64_t> {
  static constexpr std::string_view name = "integer";
  static std::int64_t read(lua_State* L, int index) { return luaL_checkinteger(L, index); }
  static void push(lua_State* L, std::int64_t number) { lua_pushinteger(L, number); }
};

template <>
struct Value<bool> {
  static constexpr std::string_view name = "boolean";
  static bool read(lua_State* L, int index) {
    luaL_checktype(L, index, LUA_TBOOLEAN);
    return lua_toboolean(L, index) != 0;
  }
  static void push(lua_State* L, bool yes) { lua_pushboolean(L, yes ? 1 : 0); }
};

/// Valid while the function runs: the caller owns the string.
template <>
struct Value<std::string_view> {
  static constexpr std::string_view name = "string";
  static std::string_view read(lua_State* L, int index) {
    std::size_t length = 0;
    const char* text = luaL_checklstring(L, index, &length);
    return {text, length};
  }
  static void push(lua_State* L, std::string_view text) { lua_pushlstring(L, text.data(), text.size()); }
};

/// Only as a result.
template <>
struct Value<std::string> {
  static constexpr std::string_view name = "string";
  static void push(lua_State* L, const std::string& text) { lua_pushlstring(L, text.data(), text.size()); }
};

template <typename T>
struct Value<std::optional<T>> {
  static std::optional<T> read(lua_State* L, int index) {
    if (lua_isnoneornil(L, index)) return std::nullopt;
    return Value<T>::read(L, index);
  }
};

template <auto Method>
struct Bound;

/// The object is the closure's first upvalue. A std::exception becomes a Lua error at the caller's line.
template <typename Self, typename Result, typename... Arguments, Result (Self::*Method)(Arguments...)>
struct Bound<Method> {
  static int call(lua_State* L) {
    constexpr std::int64_t kPriceOfACall = 10;  // about 80 ns, an instruction 7
    Sandbox::of(L).charge(kPriceOfACall);
    const int results = attempt(L, std::index_sequence_for<Arguments...>{});
    if (results >= 0) return results;
    luaL_where(L, 1);
    lua_insert(L, -2);
    lua_concat(L, 2);
    return lua_error(L);
  }

 private:
  /// Number of pushed results; -1: an error message was pushed.
  template <std::size_t... Index>
  static int attempt(lua_State* L, std::index_sequence<Index...>) {
    Self& self = *static_cast<Self*>(lua_touserdata(L, lua_upvalueindex(1)));
    try {
      if constexpr (std::is_void_v<Result>) {
        (self.*Method)(Value<Arguments>::read(L, static_cast<int>(Index) + 1)...);
        return 0;
      } else {
        const Result result = (self.*Method)(Value<Arguments>::read(L, static_cast<int>(Index) + 1)...);
        Value<Result>::push(L, result);
        return 1;
      }
    } catch (const std::exception& error) {
      lua_pushstring(L, error.what());
      return -1;
    }
  }
};

/// A member function that reads its arguments from the stack itself.
template <auto Method>
struct RawBound;

template <typename Self, int (Self::*Method)(lua_State*)>
struct RawBound<Method> {
  static int call(lua_State* L) {
    Self& self = *static_cast<Self*>(lua_touserdata(L, lua_upvalueindex(1)));
    int results = -1;
    try {
      results = (self.*Method)(L);
    } catch (const std::exception& error) {
      luaL_where(L, 1);
      lua_pushstring(L, error.what());
    }
    if (results >= 0) return results;
    lua_concat(L, 2);
    return lua_error(L);
  }
};

}  // namespace reorient::lua

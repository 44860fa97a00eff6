// SPDX-License-Identifier: MIT
#include "engine/script/sandbox/metatables.h"

#include <algorithm>
#include <cstdint>

#include "engine/script/sandbox/sandbox.h"

namespace reorient {
namespace {

constexpr const char* kList = "metatables";  // in the registry: their set, with weak keys

}  // namespace

void Metatables::open(lua_State* L) {
  lua_newtable(L);
  lua_createtable(L, 0, 1);
  lua_pushliteral(L, "k");
  lua_setfield(L, -2, "__mode");
  lua_setmetatable(L, -2);
  lua_setfield(L, LUA_REGISTRYINDEX, kList);
}

void Metatables::admit(lua_State* L, int index) {
  const int metatable = lua_absindex(L, index);
  lua_getfield(L, LUA_REGISTRYINDEX, kList);
  lua_pushvalue(L, metatable);
  const bool is_known = lua_rawget(L, -2) != LUA_TNIL;
  lua_pop(L, 1);
  if (!is_known) {
    if (held_ >= next_census_) take_census(L);
    if (held_ >= kMost) {
      luaL_error(L, "too many metatables (expected at most %d): let tables of the same type share one",
                 static_cast<int>(kMost));
    }
    lua_pushvalue(L, metatable);
    lua_pushboolean(L, 1);
    lua_rawset(L, -3);
    ++held_;
  }
  lua_pop(L, 1);
}

/// Counts those that are still in use; the list is on top of the stack. A script may create a new one in each frame.
void Metatables::take_census(lua_State* L) {
  constexpr std::size_t kBytesPerInstruction = 16;  // a full garbage collection takes about 0.5 ns per byte
  Sandbox& sandbox = Sandbox::of(L);
  sandbox.charge(static_cast<std::int64_t>(sandbox.memory() / kBytesPerInstruction));
  lua_gc(L, LUA_GCCOLLECT);
  held_ = 0;
  for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) ++held_;
  next_census_ = std::min(held_ + kBetweenCensuses, kMost);
}

}  // namespace reorient

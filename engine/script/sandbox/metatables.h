// SPDX-License-Identifier: MIT
// How many metatables a script may hold. Lua follows __index, __newindex and __call from table to table within one
// instruction, where nothing counts; each link of such a chain has a metatable of its own, so few of them make short
// chains. (Lua itself ends a circle of __index, and the sandbox one of __call: it fills the stack.)
#pragma once

#include <cstddef>

#include <lua.hpp>

namespace reorient {

class Metatables {
 public:
  /// Opens the list of them in the state's registry.
  static void open(lua_State* L);

  /// Before the table at `index` becomes a metatable. Raises a Lua error where the script holds as many as it may.
  void admit(lua_State* L, int index);

  /// How many there are, perhaps with some that nothing refers to any more.
  std::size_t held() const { return held_; }

  static constexpr std::size_t kMost = 32;

 private:
  static constexpr std::size_t kBetweenCensuses = 8;

  void take_census(lua_State* L);

  std::size_t held_ = 0;
  std::size_t next_census_ = kBetweenCensuses;
};

}  // namespace reorient

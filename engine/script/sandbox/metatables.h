// SPDX-License-Identifier: MIT
// Limits the number of metatables of a script. Lua follows __index, __newindex and __call from table to table within
// one instruction, which the budget does not count; each link of such a chain has its own metatable, so few of them
// limit the chain. (Lua itself stops a cycle of __index. The sandbox stops a cycle of __call, which fills the stack.)
#pragma once

#include <cstddef>

#include <lua.hpp>

namespace reorient {

class Metatables {
 public:
  /// Creates their list in the state's registry.
  static void open(lua_State* L);

  /// Call before the table at `index` becomes a metatable. Raises a Lua error if the script has reached the limit.
  void admit(lua_State* L, int index);

  /// Their number, possibly including unreachable ones.
  std::size_t held() const { return held_; }

  static constexpr std::size_t kMost = 32;

 private:
  static constexpr std::size_t kBetweenCensuses = 8;

  void take_census(lua_State* L);

  std::size_t held_ = 0;
  std::size_t next_census_ = kBetweenCensuses;
};

}  // namespace reorient

// SPDX-License-Identifier: MIT
// How two Lua values differ, for people.
#pragma once

#include <string>

#include <lua.hpp>

namespace reorient {

/// Nothing when the values at these stack indices are equal. Tables are compared field by field; one line for each
/// field that differs, is missing or is too many: "at .flips: expected 1, actual 2". The script pays for the work.
std::string value_differences(lua_State* L, int actual, int expected);

}  // namespace reorient

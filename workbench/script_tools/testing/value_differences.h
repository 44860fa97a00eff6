// SPDX-License-Identifier: MIT
// Differences of two Lua values as readable text.
#pragma once

#include <string>

#include <lua.hpp>

namespace reorient {

/// Empty if the values at these stack indices are equal. Tables are compared field by field, with one line for each
/// field that differs, is missing or is unexpected: "at .flips: expected 1, actual 2". The script pays for the work.
std::string value_differences(lua_State* L, int actual, int expected);

}  // namespace reorient

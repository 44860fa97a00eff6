// SPDX-License-Identifier: MIT
// The parts of Lua's standard library that scripts may use, with safe replacements for unbounded or unsafe functions.
#pragma once

#include <lua.hpp>

namespace reorient {

/// Fills the globals: base functions, math, table, string. No io, os, debug, load, coroutine, collectgarbage; no way
/// to run a finalizer (they run outside of every budget); order and text of tables do not depend on addresses.
void open_safe_library(lua_State* L);

/// Adds the string functions (a field of the table on top of the stack per function).
void add_safe_strings(lua_State* L);

/// As Lua's tostring, without addresses. Pushes the text of the value at `index`.
void push_text(lua_State* L, int index);

}  // namespace reorient

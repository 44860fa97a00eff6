// SPDX-License-Identifier: MIT
// Fields of an application (robots/application.h) as values of Lua: a point is a table with x and y, a pose one with x,
// y and rotation, a record one with the names of its fields, a list one of records from 1 on.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <lua.hpp>

#include "robots/application.h"

namespace reorient {

/// Pushes the content of a declared value. Tables are read-only. `what` names it in errors: "input.ball.position".
void push_content(lua_State* L, const DeclaredValue& value, const FieldData& data, std::uint32_t records,
                  const std::string& what);

/// Pushes one of several fields. Throws std::runtime_error with one line if there is no field of this name.
void push_argument(lua_State* L, const std::vector<DeclaredField>& fields, const FieldData& data,
                   const std::string& name, const std::string& what);

/// Index of an action. Throws std::runtime_error with one line for an unknown name.
std::uint16_t action_named(const ApplicationInterface& declared, std::string_view name);

/// A report in a script or a test. Throws std::runtime_error with one line if the state is not one to report, or `id`
/// is 0.
ActionReport report_of(std::uint32_t id, std::string_view state, std::string_view reason);

/// Reads the table at `index`, with the names of the fields; default values for those that are left out; nil: all of
/// them. Throws std::runtime_error with one line: "kick: foot: expected left or right, found 'up'".
FieldData read_record(lua_State* L, int index, const std::vector<DeclaredField>& fields, const std::string& what);

/// Reads a table such as { ball = { x = 1.0, seen = true }, teammates = { { number = 2 } } }. Throws std::runtime_error
/// with one line.
std::vector<SetValue> read_inputs(lua_State* L, int index, const ApplicationInterface& declared);

/// Reads the content of a declared value. Throws std::runtime_error with one line that begins with the value's name.
SetValue read_content(lua_State* L, int index, const ApplicationInterface& declared, std::uint16_t value);

}  // namespace reorient

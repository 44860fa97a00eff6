// SPDX-License-Identifier: MIT
// Arguments of behaviors that other behaviors run: `run "walk_to" { x = 1.0 }` gives values, and `args { x = ... }`
// declares them.
#pragma once

#include <optional>

#include <lua.hpp>

#include "engine/parameters/parameter.h"

namespace reorient {

/// The number, boolean or string at `index`; nothing: a value of another type.
std::optional<ParameterValue> parameter_value(lua_State* L, int index);

/// What to do with a number outside of the range of its argument.
enum class OutOfRange { refuse, clamp };

/// The value that an argument has if its caller gives `value`. Throws std::runtime_error with one line if the type does
/// not fit, or a number is not finite.
ParameterValue fitted_argument(const ParameterDeclaration& argument, const ParameterValue& value, OutOfRange policy);

}  // namespace reorient

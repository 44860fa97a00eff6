// SPDX-License-Identifier: MIT
// The values and actions of an application in the Lua of a behavior. `input.ball.x` is a value, `input.age.ball.x` the
// seconds since it was set, `input.valid.ball.x` whether it is valid. `action.kick { foot = "left" }` requests an
// action, and action.kick.state, .reason and .time_in_state are the state of its latest start.
#pragma once

#include <lua.hpp>

namespace reorient {

class BehaviorLanguage;

/// Makes the globals `input` and `action` of `L`. The language must outlive it.
void add_application_tables(lua_State* L, BehaviorLanguage& language);

}  // namespace reorient

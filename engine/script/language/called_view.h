// SPDX-License-Identifier: MIT
// What a behavior sees of the behaviors that it runs: `called.walk_to.outcome`, `done "walk_to"`, `failed "walk_to"`.
#pragma once

#include <string>

#include <lua.hpp>

#include "engine/script/language/behavior_view.h"
#include "engine/script/language/script_actions.h"

namespace reorient {

/// Makes the globals `called`, `done` and `failed` of `L`. Both references must outlive it.
void add_called_view(lua_State* L, const MachineDirectory& directory, const ScriptActions& actions);

/// The behavior whose end the function with this reference awaits; empty: another function.
std::string awaited_behavior(lua_State* L, int function);

}  // namespace reorient

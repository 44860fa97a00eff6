// SPDX-License-Identifier: MIT
// From the table that a test gives to simulate { ... }.
#pragma once

#include <lua.hpp>

#include "workbench/script_tools/testing/simulation.h"

namespace reorient {

/// What the table at the stack index does not name keeps its default. Throws std::runtime_error with one line.
SimulationRequest read_simulation_request(lua_State* L, int table);

}  // namespace reorient

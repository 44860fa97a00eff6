// SPDX-License-Identifier: MIT
// Reads the table of simulate { ... } in a test.
#pragma once

#include <lua.hpp>

#include "workbench/script_tools/testing/simulation.h"

namespace reorient {

/// Keys that are missing in the table at the stack index keep their defaults. Throws std::runtime_error with one line.
SimulationRequest read_simulation_request(lua_State* L, int table);

}  // namespace reorient

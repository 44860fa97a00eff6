// SPDX-License-Identifier: MIT
// A script that failed, as an exception: thrown by the host's own code once Lua's stack is unwound, never through it.
#pragma once

#include <stdexcept>
#include <utility>
#include <vector>

#include "engine/script/sandbox/sandbox.h"

namespace reorient {

struct ScriptError : std::runtime_error {
  explicit ScriptError(ScriptFault what) : std::runtime_error(what.text()), fault(std::move(what)), all{fault} {}

  ScriptFault fault;
  std::vector<ScriptFault> all;  ///< that one look at the script found, `fault` among them
};

}  // namespace reorient

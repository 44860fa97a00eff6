// SPDX-License-Identifier: MIT
// The error of a script as an exception: thrown by the host after Lua's stack is unwound, never through it.
#pragma once

#include <stdexcept>
#include <utility>
#include <vector>

#include "engine/script/sandbox/sandbox.h"

namespace reorient {

struct ScriptError : std::runtime_error {
  explicit ScriptError(ScriptFault what) : std::runtime_error(what.text()), fault(std::move(what)), all{fault} {}

  ScriptFault fault;
  std::vector<ScriptFault> all;  ///< all errors found, including `fault`
};

}  // namespace reorient

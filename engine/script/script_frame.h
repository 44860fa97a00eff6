// SPDX-License-Identifier: MIT
// One frame of a script in the host: for the sources of ScriptHost only.
#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/script/script_error.h"
#include "engine/script/script_host.h"
#include "engine/script/script_slot.h"

namespace reorient {

/// Calls `run`, which runs the machines of a script, and notes what it costs and where it fails.
template <typename Run>
void ScriptHost::run_frame(ScriptSlot& slot, std::span<const double> world, Run&& run) {
  const auto begin = std::chrono::steady_clock::now();
  ++slot.frames;
  slot.script->begin_frame(world);
  std::optional<ScriptFault> failure;
  try {
    run();
  } catch (ScriptError& error) {
    failure = std::move(error.fault);
  }
  slot.script->end_frame();
  slot.microseconds = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
  std::vector<ScriptFault> faults;
  faults.swap(slot.script->exit_faults());
  if (failure) faults.push_back(std::move(*failure));
  note_faults(slot, std::move(faults));
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "program/run/script_edits.h"

#include <utility>

#include "program/monotonic_clock.h"

namespace reorient {

void ScriptEdits::add_to(FrameInputs& inputs) {
  for (ScriptEdit& edit : std::exchange(missed_, {})) inputs.script_edits.push_back(std::move(edit));
  for (ScriptEdit& edit : files_.poll(monotonic_clock())) inputs.script_edits.push_back(std::move(edit));
}

}  // namespace reorient

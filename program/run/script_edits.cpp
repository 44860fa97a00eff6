#include "program/run/script_edits.h"

#include <chrono>
#include <utility>

namespace reorient {

void ScriptEdits::add_to(FrameInputs& inputs) {
  for (ScriptEdit& edit : std::exchange(missed_, {})) inputs.script_edits.push_back(std::move(edit));
  const std::chrono::duration<double> now = std::chrono::steady_clock::now().time_since_epoch();
  for (ScriptEdit& edit : files_.poll(now.count())) inputs.script_edits.push_back(std::move(edit));
}

}  // namespace reorient

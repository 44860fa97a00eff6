// SPDX-License-Identifier: MIT
// Everything that reaches a frame. Nothing else does.
#pragma once

#include <vector>

#include "engine/parameters/parameter.h"
#include "engine/script/script_texts.h"
#include "robots/robot.h"

namespace reorient {

struct FrameInputs {
  Observation observation;
  std::vector<ParameterChange> parameter_changes;
  std::vector<ScriptEdit> script_edits;  ///< texts, not files
  ExternalInputs external;               ///< by others than the robot's own software: a person, a scenario
};

}  // namespace reorient

// SPDX-License-Identifier: MIT
// All inputs of a frame.
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
  ExternalInputs external;               ///< from outside the robot's software: the operator or a scenario
};

}  // namespace reorient

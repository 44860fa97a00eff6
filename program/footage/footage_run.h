// SPDX-License-Identifier: MIT
// The engine with footage as its input, ready to run.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/frame.h"
#include "program/run/engine_setup.h"
#include "program/run/footage_arguments.h"
#include "robots/footage/footage_robot.h"
#include "workbench/run/run_loop.h"

namespace reorient {

/// The setup of the engine. No motion is executed, so only behaviors that request no motion are loaded.
struct FootageSetup : EngineOptions {
  std::filesystem::path source;
  FootageArguments footage;
  std::optional<SavedModel> model;  ///< of the room, learned before
  std::string at;                   ///< X,Y,DEGREES: first pose if the footage has no positions; empty: unknown
};

struct PreparedFootage {
  FrameSetup frame;                   ///< with the wall that suits the footage
  std::vector<ParameterChange> kept;  ///< overrides of scripts that are not in this run
  std::string wall;                   ///< a line for the user
};

/// Reports mistakes before it fits the wall, which takes a while. Throws std::runtime_error (of scripts:
/// ScriptError) with one line.
PreparedFootage prepare_footage(const FootageSetup& setup, const ScriptTexts& scripts);

/// Options of the robot, without changes of its belief.
FootageOptions robot_options_of(const FootageSetup& setup);

}  // namespace reorient

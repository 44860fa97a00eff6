// SPDX-License-Identifier: MIT
// The setup of the engine from options, for any robot.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/frame.h"
#include "program/options.h"

namespace reorient {

struct EngineOptions {
  std::filesystem::path body;          ///< TOML file, or the name of a shipped one; empty: the NAO
  std::filesystem::path field;         ///< TOML file, or the name of a shipped one; empty: the body's
  std::filesystem::path scripts;       ///< root of the scripts
  std::filesystem::path interface;     ///< TOML file, or the name of a shipped one; empty: the scenario's or robot's
  std::vector<std::string> behaviors;  ///< if no scenario lists them; empty: all that the robot supports
  ParameterOptions parameters;
  std::uint64_t seed = 1;
  bool room_awareness = true;
};

/// The requests of behaviors that the robot executes.
struct Abilities {
  bool head = true;
  bool walk = true;
  bool get_up = true;
};

/// The shipped behaviors that a robot can use.
std::vector<std::string> behaviors_for(const Abilities& abilities);

/// Without body, field, behaviors and model. `parameters`: overrides_of() the options.
FrameSetup engine_setup(const EngineOptions& options, const ScriptTexts& scripts,
                        std::vector<ParameterChange> parameters);
/// Without a model. Throws std::runtime_error with one line about the options' parameters or behaviors.
FrameSetup engine_setup(const EngineOptions& options, const ScriptTexts& scripts, RobotBody body,
                        const FieldDimensions& field, const Abilities& abilities);

}  // namespace reorient

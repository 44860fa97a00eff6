// Everything that can be tuned in a simulated run, under one roof.
#pragma once

#include "engine/core_parameters.h"
#include "engine/parameters/parameter_registry.h"
#include "engine/script/sandbox/script_limits.h"
#include "program/options.h"
#include "robots/simulator/simulator.h"

namespace reorient {

struct Tuning {
  CoreParameters core;
  ScriptLimits script;
  SimulatorParameters simulator;
  RoomShape room_shape;
  ParameterRegistry registry;  ///< of all of these; scripts add theirs

  /// `image_width`: 640, 320 or 160 pixels; of no account where no image is made.
  explicit Tuning(int image_width = 320);
  Tuning(const Tuning&) = delete;
  Tuning& operator=(const Tuning&) = delete;

  /// Names may be those of scripts that are loaded later. Throws std::runtime_error with one line.
  void override_by(const ParameterOptions& options);
  /// To be called when all scripts are loaded. Throws as override_by().
  void require_all_claimed() const;
};

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Commands of the prompt for behaviors and the scenario: their states, their transitions, and reloads.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/frame.h"
#include "program/run/console/command.h"

namespace reorient {

class ScriptCommands {
 public:
  /// `scenario` may be nullptr; `on_disk`: the scripts as last read from the disk, which no command waits for;
  /// `engine`: that of the running behaviors, nullptr without a robot; may be empty.
  ScriptCommands(ScenarioHost* scenario, std::function<const ScriptTexts*()> on_disk,
                 std::function<const FrameLoop*()> engine = {});

  /// All machines with state and cost; needs Topic::costs.
  static Reply states();
  /// The transitions that this machine may take, with the world's values that their conditions read; needs
  /// Topic::conditions.
  Reply why(const std::string& machine) const;
  /// Reloads scripts, also unchanged ones; an empty name: all.
  Reply reload(const std::string& name, FrameInputs& inputs) const;

  /// The names of all machines, for completion.
  void observe(const FrameRecord& frame, const SceneTruth& scene);
  const Words& machines() const { return machines_; }
  /// Names that reload() takes.
  Words scripts() const;

 private:
  ScenarioHost* scenario_;
  std::function<const ScriptTexts*()> on_disk_;
  std::function<const FrameLoop*()> engine_;
  Words machines_;
};

}  // namespace reorient

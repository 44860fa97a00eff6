// SPDX-License-Identifier: MIT
// Commands of the prompt for behaviors and the scenario: their states, why they are in them, and a reload.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "program/run/console/command.h"

namespace reorient {

class ScriptCommands {
 public:
  /// `scenario` may be nullptr; `root`: the folder of the scripts.
  ScriptCommands(ScenarioHost* scenario, std::filesystem::path root);

  /// Every machine with its state and what it costs: needs Topic::costs.
  static Reply states();
  /// The transitions that this machine may take: needs Topic::conditions.
  Reply why(const std::string& machine) const;
  /// Reads scripts again, also those that did not change; an empty name: all.
  Reply reload(const std::string& name, FrameInputs& inputs) const;

  /// The names of all machines, for completion.
  void observe(const FrameRecord& frame, const SceneTruth& scene);
  const Words& machines() const { return machines_; }
  /// Names that reload() takes.
  Words scripts() const;

 private:
  ScenarioHost* scenario_;
  std::filesystem::path root_;
  Words machines_;
};

}  // namespace reorient

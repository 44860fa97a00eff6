// SPDX-License-Identifier: MIT
// Commands of the prompt for parameters: set, undo, list, compare with the defaults, save.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "program/run/console/command.h"
#include "workbench/scenario/parameter_edits.h"

namespace reorient {

class ParameterCommands {
 public:
  /// `scenario` may be nullptr; `parameters`: all existing ones; `kept_parameters`: of scripts that are not loaded, may
  /// be empty.
  ParameterCommands(ScenarioHost* scenario, std::function<std::vector<Parameter>()> parameters,
                    std::function<std::vector<ParameterChange>()> kept_parameters);

  Reply set(const std::string& name, const std::string& value, FrameInputs& inputs);
  /// Undoes the change that was requested last; called again, the one before it.
  Reply undo(FrameInputs& inputs);
  Reply list(const std::string& pattern) const;
  Reply differences() const;
  Reply save(const std::string& file) const;

  Words names() const;
  /// Completions for a value: the choices of the parameter, or its present value.
  Words values(const std::string& name) const;

 private:
  /// `refused` is called if the change was refused.
  Reply change(const ParameterChange& wanted, FrameInputs& inputs, std::function<void()> refused);

  ScenarioHost* scenario_;
  std::function<std::vector<Parameter>()> parameters_;
  std::function<std::vector<ParameterChange>()> kept_parameters_;
  UndoableChanges before_;
};

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "workbench/scenario/parameter_edits.h"

namespace reorient {

ParameterChange change_back_to(const Parameter& present) {
  const bool is_default = present.origin == ParameterOrigin::default_value;
  return {present.name, to_text(present.value), is_default ? present.origin : ParameterOrigin::live, ""};
}

std::optional<ParameterOutcome> request_change(const ParameterChange& change, ScenarioHost* scenario,
                                               FrameInputs& inputs) {
  inputs.parameter_changes.push_back(change);
  return scenario != nullptr ? scenario->change(change) : std::nullopt;
}

ParameterOutcome outcome_of_change(const std::string& name, const std::optional<ParameterOutcome>& by_scenario,
                                   const FrameRecord& frame) {
  ParameterOutcome outcome{name, {}, {}};
  for (const ParameterOutcome& one : frame.parameter_changes) {
    if (one.name == name) outcome = one;
  }
  if (by_scenario) outcome = *by_scenario;  // the engine may not have this parameter
  if (outcome.value.empty()) outcome.refusal = name + " is fixed during a run; set it with --set";
  return outcome;
}

}  // namespace reorient

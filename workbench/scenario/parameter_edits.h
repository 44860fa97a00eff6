// SPDX-License-Identifier: MIT
// A change of a parameter during a run, asked for at the prompt or by a viewer.
#pragma once

#include <optional>
#include <string>

#include "engine/frame_inputs.h"
#include "engine/parameters/parameter.h"
#include "engine/record/frame_record.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {

/// Number of changes that one user can undo.
inline constexpr std::size_t kMostUndoneChanges = 1000;

/// The change that undoes a later one. A default is not a value that was set: undoing returns to what is the default
/// then, which an edit may have changed.
ParameterChange change_back_to(const Parameter& present);

/// Adds the change to the next frame. A library's parameter may belong to behaviors and to the scenario, which may be
/// nullptr: both are changed. Returns what the scenario did; nothing: it does not have this parameter.
std::optional<ParameterOutcome> request_change(const ParameterChange& change, ScenarioHost* scenario,
                                               FrameInputs& inputs);

/// What became of it, after the frame. `by_scenario`: from request_change().
ParameterOutcome outcome_of_change(const std::string& name, const std::optional<ParameterOutcome>& by_scenario,
                                   const FrameRecord& frame);

}  // namespace reorient

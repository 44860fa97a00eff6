// SPDX-License-Identifier: MIT
// A change of a parameter during a run, requested at the prompt or by a viewer, and what undoes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/frame_inputs.h"
#include "engine/parameters/parameter.h"
#include "engine/record/frame_record.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {

/// A change that the next frame makes.
struct RequestedChange {
  std::string name;
  std::size_t earlier = 0;                      ///< number of changes of this parameter that the frame makes before it
  std::optional<ParameterOutcome> by_scenario;  ///< nothing: the scenario does not have this parameter
};

/// Adds the change to the next frame. A library's parameter may belong to behaviors and to the scenario, which may be
/// nullptr: both are changed.
RequestedChange request_change(const ParameterChange& change, ScenarioHost* scenario, FrameInputs& inputs);

/// The result, after the frame.
ParameterOutcome outcome_of_change(const RequestedChange& change, const FrameRecord& frame);

/// The change that undoes a later one. `inputs`: of the next frame, which in a paused run contain earlier changes. A
/// default is not a value that was set: undoing returns to what is the default then, which an edit may have changed.
ParameterChange change_back_to(const Parameter& present, const FrameInputs& inputs);

/// What undoes the changes of one user. A change counts from its request on, so that an undo in a paused run undoes the
/// change that was requested last.
class UndoableChanges {
 public:
  /// `back`: from change_back_to(). Returns the number of the change. Drops the oldest change of very many.
  std::uint64_t add(ParameterChange back);
  /// Forgets a change that was refused.
  void remove(std::uint64_t number);
  /// Removes the last change, and returns what undoes it; nothing: no change is left.
  std::optional<ParameterChange> take_last();

 private:
  struct Entry {
    std::uint64_t number = 0;
    ParameterChange back;
  };

  std::vector<Entry> entries_;  ///< the latest at the end
  std::uint64_t added_ = 0;
};

}  // namespace reorient

// SPDX-License-Identifier: MIT
// A cell of an experiment once its trials are over.
#pragma once

#include <string>
#include <vector>

#include "workbench/experiments/condition/condition.h"
#include "workbench/experiments/tables/row.h"

namespace reorient {

struct CellResults {
  std::vector<std::string> choices;  ///< one for each axis
  std::vector<TrialResult> trials;   ///< in the order of the plan
  Row row;                           ///< of these trials
};

/// What stands for the room in a row that is pooled over the rooms.
inline constexpr const char* kAllRooms = "all";

/// What all rooms show together: for each choice of the other axes a row of the trials in every room, without the
/// trials themselves. None where there are not several rooms.
std::vector<CellResults> pooled_over_rooms(const Experiment& experiment, const std::vector<CellResults>& cells);

/// A sentence about trials that were never measured, because a reader of the row would count them as failures of the
/// robot. Empty: there are none.
std::string not_started_note(const CellResults& cell);

}  // namespace reorient

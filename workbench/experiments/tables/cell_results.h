// SPDX-License-Identifier: MIT
// A cell of an experiment with the results of its trials.
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

/// The name of the room in rows that are pooled over the rooms.
inline constexpr const char* kAllRooms = "all";

/// Rows that are pooled over the rooms: one for each choice of the other axes, without the trials themselves. Empty
/// unless there are several rooms.
std::vector<CellResults> pooled_over_rooms(const Experiment& experiment, const std::vector<CellResults>& cells);

/// A sentence about trials that were never measured, because a reader of the row would count them as failures of the
/// robot. Empty without such trials.
std::string not_started_note(const CellResults& cell);

}  // namespace reorient

// A cell of an experiment once its trials are over.
#pragma once

#include <string>
#include <vector>

#include "workbench/experiments/tables/row.h"

namespace reorient {

struct CellResults {
  std::vector<std::string> choices;  ///< one for each axis
  std::vector<TrialResult> trials;   ///< in the order of the plan
  Row row;                           ///< of these trials
};

/// A sentence about trials that were never measured: whoever reads the row would take them for failures of the robot.
/// Empty: there are none.
std::string not_started_note(const CellResults& cell);

}  // namespace reorient

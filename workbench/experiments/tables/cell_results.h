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

}  // namespace reorient

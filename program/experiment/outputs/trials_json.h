// SPDX-License-Identifier: MIT
// All measurements of each trial, as JSON.
#pragma once

#include <string>
#include <vector>

#include "workbench/experiments/condition/condition.h"
#include "workbench/experiments/tables/cell_results.h"

namespace reorient {

/// A list with a line for each trial, in the order of the plan: the axes' choices, the measurements, and the
/// confidences as lists of equal length (docs/experiments.md). Unknown values are null.
std::string trials_as_json(const Experiment& experiment, const std::vector<CellResults>& cells);

}  // namespace reorient

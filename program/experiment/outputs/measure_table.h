// SPDX-License-Identifier: MIT
// The measures of an experiment: a row for each cell and measure, as text and as JSON.
#pragma once

#include <iosfwd>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "workbench/experiments/condition/condition.h"
#include "workbench/experiments/tables/cell_results.h"

namespace reorient {

/// Prints nothing for an experiment without measures.
void print_measures(const Experiment& experiment, const std::vector<CellResults>& cells, std::ostream& out);

/// Adds "measures", an object with an entry for each (docs/experiments.md), unless the experiment has none.
void add_measures(const std::vector<Measure>& measures, const std::vector<MeasureRow>& rows,
                  nlohmann::ordered_json& json);

}  // namespace reorient

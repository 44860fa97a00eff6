// SPDX-License-Identifier: MIT
// How well room awareness and its peers distinguish a pose from the mirrored pose: a row for each, as text and as JSON.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "workbench/experiments/condition/condition.h"
#include "workbench/experiments/tables/cell_results.h"

namespace reorient {

void print_compasses(const Experiment& experiment, const std::vector<CellResults>& cells, std::ostream& out);

/// A list of rows: the axes' choices ("all": pooled), the method, and its numbers (docs/peers.md); ends with a line
/// break.
std::string compasses_as_json(const Experiment& experiment, const std::vector<CellResults>& cells);

}  // namespace reorient

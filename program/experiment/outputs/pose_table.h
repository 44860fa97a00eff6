// SPDX-License-Identifier: MIT
// Errors of the belief: a row for each cell, as text and as JSON.
#pragma once

#include <iosfwd>
#include <optional>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "workbench/experiments/condition/condition.h"
#include "workbench/experiments/tables/cell_results.h"

namespace reorient {

/// Whether any trial compared its belief with the truth frame by frame.
bool have_pose_errors(const std::vector<CellResults>& cells);

void print_pose_errors(const Experiment& experiment, const std::vector<CellResults>& cells, std::ostream& out);

/// Adds the numbers of a row (docs/experiments.md), unless nothing was measured.
void add_pose_errors(const std::optional<PoseRow>& row, nlohmann::ordered_json& json);

}  // namespace reorient

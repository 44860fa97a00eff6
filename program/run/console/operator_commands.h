// SPDX-License-Identifier: MIT
// Commands of the prompt for the operator beside the field, and for the pace of the run.
#pragma once

#include <vector>

#include "program/run/console/command.h"
#include "workbench/run/run_controls.h"

namespace reorient {

/// `controls`: of the run, may be nullptr, in which case every command is refused. They must outlive the commands.
std::vector<Command> operator_commands(RunControls* controls);

/// Whether the run is paused.
bool is_paused(const RunControls* controls);

}  // namespace reorient

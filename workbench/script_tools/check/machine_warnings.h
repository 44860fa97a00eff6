// SPDX-License-Identifier: MIT
// Warnings about a machine.
#pragma once

#include <vector>

#include "engine/script/machine/machine_definition.h"

namespace reorient {

/// Warns of a name different from the file's, of states that no path of transitions reaches, of innermost states of
/// behaviors that no transition leaves (in a scenario, such a state is the end with the verdict), and of transitions to
/// a parent of their state, which are never taken. In the order of the text.
std::vector<DeclarationError> machine_warnings(const MachineDefinition& machine);

}  // namespace reorient

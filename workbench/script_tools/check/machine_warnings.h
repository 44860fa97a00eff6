// SPDX-License-Identifier: MIT
// Warnings about a machine.
#pragma once

#include <vector>

#include "engine/script/machine/machine_definition.h"

namespace reorient {

/// A name other than its file's, the states that no path of transitions reaches, the innermost states of behaviors
/// without a way out (in a scenario such a state is the end, which gives the verdict), and transitions into a state
/// around their own, which are never taken. In the order of the text.
std::vector<DeclarationError> machine_warnings(const MachineDefinition& machine);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// State machines as JSON, for programs that draw or explain them.
#pragma once

#include <span>
#include <string>

#include "engine/script/machine/machine_definition.h"
#include "engine/script/script_texts.h"
#include "workbench/script_tools/graph/machine_graph.h"

namespace reorient {

/// One object: {name, file, line, scenario, states, transitions}. State 0 is the machine itself. `outer`, `initial`,
/// `from` and `to` are indexes of states; -1: none. The transitions are in the order of their states, as they are
/// checked. `texts`: those of the scripts, in which ConditionFields finds the fields that a condition `reads`.
std::string machine_json(const MachineDefinition& machine, const ScriptTexts& texts);

/// {machines, links}. A link is {from_machine, from_state, to_machine, to_state, label}: indexes as in MachineLink.
std::string to_json(std::span<const MachineDefinition> machines, std::span<const MachineLink> links,
                    const ScriptTexts& texts);

}  // namespace reorient

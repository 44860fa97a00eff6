// SPDX-License-Identifier: MIT
// State machines as diagrams: text for Mermaid (which GitHub shows in Markdown) and for Graphviz.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/script/machine/machine_definition.h"
#include "engine/script/script_texts.h"

namespace reorient {

/// A link: a state of one machine runs another machine, or a condition in a state of one machine reads a state of
/// another machine.
struct MachineLink {
  int from_machine = 0;  ///< index into the machines of the picture
  int from_state = 0;    ///< state that runs the other machine, is read or publishes a flag; 0: any state
  int to_machine = 0;
  int to_state = 0;   ///< state whose code reads it; 0: the machine itself, so all states
  std::string label;  ///< "runs", "pose_is_searched", "state", "time_in_state"
};

/// Calls, and uses of `published` and `behaviors` in the scripts of these machines, as far as sights_of() finds them. A
/// machine that reads its own state has no link.
std::vector<MachineLink> machine_links(std::span<const MachineDefinition> machines, const ScriptTexts& texts);

/// Text for Mermaid, without the fence. One machine gives a state diagram, in which transitions of the machine itself
/// leave a state "any state". Several machines give a flowchart with a subgraph for each machine and each state with
/// inner states.
std::string to_mermaid(std::span<const MachineDefinition> machines, std::span<const MachineLink> links = {});

/// A Graphviz digraph in which states with inner states are clusters. For one machine, `common` transitions are dashed.
/// Of several machines, each is a cluster, and links are dashed.
std::string to_dot(std::span<const MachineDefinition> machines, std::span<const MachineLink> links = {});

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Machines as a picture: text for Mermaid (which README files show) and for Graphviz.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/script/machine/machine_definition.h"
#include "engine/script/script_texts.h"

namespace reorient {

/// A state of one machine decides what happens in a state of another.
struct MachineLink {
  int from_machine = 0;  ///< index into the machines of the picture
  int from_state = 0;    ///< that is looked at, or publishes; 0: whichever it is in
  int to_machine = 0;
  int to_state = 0;   ///< in which it is looked at; 0: in all of them
  std::string label;  ///< "pose_is_searched", "state", "time_in_state"
};

/// `published` and `behaviors` in the scripts of these machines, as far as sights_of() finds them. A machine that looks
/// at itself has no link.
std::vector<MachineLink> machine_links(std::span<const MachineDefinition> machines, const ScriptTexts& texts);

/// Mermaid, without the fence: of one machine a state diagram, in which transitions of the machine itself leave a state
/// "any state"; of several a flowchart, with a subgraph for each machine and each state with states in it.
std::string to_mermaid(std::span<const MachineDefinition> machines, std::span<const MachineLink> links = {});

/// A Graphviz digraph: nested states are clusters. Of one machine, `common` transitions are dashed; each of several is
/// a cluster, and links are dashed.
std::string to_dot(std::span<const MachineDefinition> machines, std::span<const MachineLink> links = {});

}  // namespace reorient

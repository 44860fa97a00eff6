// A machine as a picture: text for Mermaid (which README files show) and for Graphviz.
#pragma once

#include <string>

#include "engine/script/machine/machine_definition.h"

namespace reorient {

/// A Mermaid state diagram, without the fence. Transitions of the machine itself leave a state "any state".
std::string to_mermaid(const MachineDefinition& machine);

/// A Graphviz digraph: nested states are clusters, `common` transitions are dashed.
std::string to_dot(const MachineDefinition& machine);

}  // namespace reorient

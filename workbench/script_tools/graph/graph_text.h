// Names, labels and quotes, as graphs of one and of several machines write them.
#pragma once

#include <string>

#include "engine/script/machine/machine_definition.h"

namespace reorient {

/// Letters, digits and _ in place of all else; `any_state` for the machine itself.
std::string state_identifier(const StateDefinition& state);

/// The reason, and how long it takes.
std::string transition_label(const TransitionDefinition& transition);

/// Nothing in it ends a line, a label or a statement of Mermaid's.
std::string mermaid_text(const std::string& text);

/// In quotes.
std::string dot_text(const std::string& text);

/// Whether some transition is the machine's own, and leads out of whichever state.
bool has_common_way(const MachineDefinition& machine);

/// Graphviz draws edges between nodes only: this one stands for the state that holds it.
int innermost_state(const MachineDefinition& machine, int state);

}  // namespace reorient

#include "workbench/script_tools/check/machine_warnings.h"

#include <algorithm>

namespace reorient {
namespace {

std::vector<bool> reached_states(const MachineDefinition& machine) {
  std::vector<bool> reached(machine.states.size(), false);
  std::vector<int> next{0};
  while (!next.empty()) {
    const int state = next.back();
    next.pop_back();
    if (reached[state]) continue;
    reached[state] = true;
    const StateDefinition& definition = machine.states[state];
    if (definition.initial >= 0) next.push_back(definition.initial);
    if (definition.parent >= 0) next.push_back(definition.parent);
    for (const int index : definition.transitions) next.push_back(machine.transitions[index].to);
  }
  return reached;
}

/// Its own transitions, those of the states around it and those of the states in it may all lead out of it.
bool has_way_out(const MachineDefinition& machine, int state) {
  return std::any_of(machine.transitions.begin(), machine.transitions.end(), [&](const TransitionDefinition& way) {
    return (machine.is_within(state, way.from) || machine.is_within(way.from, state)) &&
           !machine.is_within(way.to, state);
  });
}

}  // namespace

std::vector<DeclarationError> machine_warnings(const MachineDefinition& machine) {
  const std::vector<bool> reached = reached_states(machine);
  std::vector<DeclarationError> found;
  for (std::size_t i = 1; i < machine.states.size(); ++i) {
    const StateDefinition& state = machine.states[i];
    if (!reached[i]) {
      found.push_back({state.position, "state '" + state.path + "' is never reached", state.file});
    } else if (!machine.is_scenario && state.children.empty() && machine.states[state.parent].children.size() > 1 &&
               !has_way_out(machine, static_cast<int>(i))) {
      found.push_back({state.position, "state '" + state.path + "' has no way out", state.file});
    }
  }
  return found;
}

}  // namespace reorient

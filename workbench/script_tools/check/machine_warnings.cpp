// SPDX-License-Identifier: MIT
#include "workbench/script_tools/check/machine_warnings.h"

#include <algorithm>
#include <filesystem>

namespace reorient {
namespace {

/// Its target is already active whenever it could be taken.
bool is_never_taken(const MachineDefinition& machine, const TransitionDefinition& transition) {
  return machine.is_within(transition.from, transition.to) && (transition.from != transition.to || transition.common);
}

/// States that can become active. A state that is entered activates its initial state; a parent is active with its
/// child.
std::vector<bool> reached_states(const MachineDefinition& machine) {
  std::vector<bool> active(machine.states.size(), false);
  std::vector<bool> entered(machine.states.size(), false);
  std::vector<int> next{0};
  while (!next.empty()) {
    const int target = next.back();
    next.pop_back();
    if (entered[target]) continue;
    entered[target] = true;
    if (machine.states[target].initial >= 0) next.push_back(machine.states[target].initial);
    for (int state = target; state >= 0 && !active[state]; state = machine.states[state].parent) {
      active[state] = true;
      for (const int index : machine.states[state].transitions) {
        const TransitionDefinition& transition = machine.transitions[index];
        if (!is_never_taken(machine, transition)) next.push_back(transition.to);
      }
    }
  }
  return active;
}

/// Transitions of the state, of its parents and of its children may leave it.
bool has_exit(const MachineDefinition& machine, int state) {
  return std::any_of(
      machine.transitions.begin(), machine.transitions.end(), [&](const TransitionDefinition& transition) {
        return (machine.is_within(state, transition.from) || machine.is_within(transition.from, state)) &&
               !machine.is_within(transition.to, state) && !is_never_taken(machine, transition);
      });
}

}  // namespace

std::vector<DeclarationError> machine_warnings(const MachineDefinition& machine) {
  const std::vector<bool> reached = reached_states(machine);
  std::vector<DeclarationError> found;
  // Usually a copied file whose machine was not renamed. Command lines use the name of the file; other scripts and
  // recordings use the name of the machine.
  if (const std::string stem = std::filesystem::path(machine.file).stem().string(); stem != machine.name) {
    found.push_back({machine.position,
                     std::string(machine.is_scenario ? "scenario" : "behavior") + " '" + machine.name +
                         "' is declared in a file with the name '" + stem + "' (expected the same name)",
                     machine.file});
  }
  for (std::size_t i = 1; i < machine.states.size(); ++i) {
    const StateDefinition& state = machine.states[i];
    if (!reached[i]) {
      found.push_back({state.position, "state '" + state.path + "' is never reached", state.file});
    } else if (!machine.is_scenario && state.ends == BehaviorEnd::none && state.children.empty() &&
               machine.states[state.parent].children.size() > 1 && !has_exit(machine, static_cast<int>(i))) {
      found.push_back({state.position, "no transition leaves state '" + state.path + "'", state.file});
    }
  }
  for (const TransitionDefinition& transition : machine.transitions) {
    if (!is_never_taken(machine, transition)) continue;
    const std::string& target = machine.states[transition.to].path;
    found.push_back({transition.position,
                     "the transition to '" + transition.target + "' is never taken: '" + target +
                         "' is already active (expected a target inside or outside of it)",
                     machine.states[transition.from].file});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& left, const auto& right) { return is_before(left.position, right.position); });
  return found;
}

}  // namespace reorient

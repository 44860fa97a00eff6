// SPDX-License-Identifier: MIT
#include "workbench/script_tools/check/machine_warnings.h"

#include <algorithm>
#include <filesystem>

namespace reorient {
namespace {

/// Its target is active whenever it could be taken.
bool is_never_taken(const MachineDefinition& machine, const TransitionDefinition& way) {
  return machine.is_within(way.from, way.to) && (way.from != way.to || way.common);
}

/// Which states can be active. One that is entered goes on to its initial state; one around it is only active with it.
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
        const TransitionDefinition& way = machine.transitions[index];
        if (!is_never_taken(machine, way)) next.push_back(way.to);
      }
    }
  }
  return active;
}

/// Its own transitions, those of the states around it and those of the states in it may all lead out of it.
bool has_way_out(const MachineDefinition& machine, int state) {
  return std::any_of(machine.transitions.begin(), machine.transitions.end(), [&](const TransitionDefinition& way) {
    return (machine.is_within(state, way.from) || machine.is_within(way.from, state)) &&
           !machine.is_within(way.to, state) && !is_never_taken(machine, way);
  });
}

}  // namespace

std::vector<DeclarationError> machine_warnings(const MachineDefinition& machine) {
  const std::vector<bool> reached = reached_states(machine);
  std::vector<DeclarationError> found;
  // Mostly a copy that kept its name. Command lines name the file, other scripts and recordings the machine.
  if (const std::string stem = std::filesystem::path(machine.file).stem().string(); stem != machine.name) {
    found.push_back({machine.position,
                     "this " + std::string(machine.is_scenario ? "scenario" : "behavior") + " is called '" +
                         machine.name + "' and its file '" + stem + "'; one name for both",
                     machine.file});
  }
  for (std::size_t i = 1; i < machine.states.size(); ++i) {
    const StateDefinition& state = machine.states[i];
    if (!reached[i]) {
      found.push_back({state.position, "state '" + state.path + "' is never reached", state.file});
    } else if (!machine.is_scenario && state.children.empty() && machine.states[state.parent].children.size() > 1 &&
               !has_way_out(machine, static_cast<int>(i))) {
      found.push_back({state.position, "state '" + state.path + "' has no way out", state.file});
    }
  }
  for (const TransitionDefinition& way : machine.transitions) {
    if (!is_never_taken(machine, way)) continue;
    const std::string& target = machine.states[way.to].path;
    found.push_back({way.position,
                     "the transition to '" + way.target + "' is never taken: '" + target +
                         "' is active all the while; name a state in it, or one beside it",
                     machine.states[way.from].file});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& left, const auto& right) { return is_before(left.position, right.position); });
  return found;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "engine/script/machine/machine_definition.h"

#include <algorithm>
#include <map>

#include "engine/parameters/nearest_name.h"

namespace reorient {
namespace {

int child_named(const MachineDefinition& machine, int state, const std::string& name) {
  for (const int child : machine.states[state].children) {
    if (machine.states[child].name == name) return child;
  }
  return -1;
}

/// Searches a name among the state's children, then its siblings, then outward; a path from the top.
int find_target(const MachineDefinition& machine, int from, const std::string& target) {
  for (int scope = from; scope >= 0; scope = machine.states[scope].parent) {
    const int found = child_named(machine, scope, target);
    if (found >= 0) return found;
  }
  return machine.find(target);
}

std::vector<std::string> state_names(const MachineDefinition& machine) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < machine.states.size(); ++i) {
    names.push_back(machine.states[i].name);
    if (machine.states[i].path != machine.states[i].name) names.push_back(machine.states[i].path);
  }
  return names;
}

std::string in_quotes(const std::string& name) { return "'" + name + "'"; }

std::string title(const StateDefinition& state) {
  return state.path.empty() ? "the machine" : "state " + in_quotes(state.path);
}

std::string derived_reason(const TransitionDefinition& transition) {
  if (transition.after.kind != Dwell::Kind::none) return "after " + transition.after.text;
  if (transition.lasting.kind != Dwell::Kind::none) return "its condition lasted " + transition.lasting.text;
  return "its condition held";
}

void resolve_initial(MachineDefinition& machine, StateDefinition& state, std::vector<DeclarationError>& errors) {
  if (state.children.empty()) {
    if (!state.initial_name.empty())
      errors.push_back({state.position, title(state) + " has an initial state but no states", state.file});
    return;
  }
  if (state.initial_name.empty()) {
    if (state.children.size() == 1) {
      state.initial = state.children.front();
    } else {
      errors.push_back({state.position,
                        title(state) + " has several states but no initial state: set initial = \"...\"", state.file});
    }
    return;
  }
  const int index = static_cast<int>(&state - machine.states.data());
  state.initial = child_named(machine, index, state.initial_name);
  if (state.initial >= 0) return;
  std::vector<std::string> names;
  for (const int child : state.children) names.push_back(machine.states[child].name);
  errors.push_back({state.position,
                    title(state) + ": unknown initial state " + in_quotes(state.initial_name) +
                        did_you_mean(state.initial_name, names),
                    state.file});
}

void check_duplicates(const MachineDefinition& machine, const StateDefinition& state,
                      std::vector<DeclarationError>& errors) {
  for (std::size_t i = 0; i < state.children.size(); ++i) {
    const StateDefinition& child = machine.states[state.children[i]];
    for (std::size_t j = 0; j < i; ++j) {
      if (machine.states[state.children[j]].name != child.name) continue;
      errors.push_back({child.position, "duplicate state " + in_quotes(child.path), child.file});
      break;
    }
  }
}

void resolve_transition(MachineDefinition& machine, TransitionDefinition& transition,
                        std::vector<DeclarationError>& errors) {
  const std::string from = title(machine.states[transition.from]);
  const std::string& file = machine.states[transition.from].file;
  transition.to = find_target(machine, transition.from, transition.target);
  if (transition.to < 0) {
    constexpr std::size_t kMostHints = 20;  // limits the search for similar names
    const std::string hint =
        errors.size() < kMostHints ? did_you_mean(transition.target, state_names(machine)) : std::string();
    errors.push_back(
        {transition.position, from + ": unknown target state " + in_quotes(transition.target) + hint, file});
  }
  const bool timed = transition.after.kind != Dwell::Kind::none;
  if (transition.when == LUA_NOREF && transition.lasting.kind != Dwell::Kind::none) {
    errors.push_back({transition.position, from + ": 'lasting' requires 'when'; for a time alone write 'after'", file});
  } else if (transition.when == LUA_NOREF && !timed) {
    errors.push_back(
        {transition.position,
         from + " leads to " + in_quotes(transition.target) + " without a condition: add 'when' or 'after'", file});
  }
  if (transition.because.empty()) transition.because = derived_reason(transition);
}

/// Along each path of states, a behavior runs once, so that its name identifies the call.
void check_calls(const MachineDefinition& machine, std::vector<DeclarationError>& errors) {
  for (std::size_t i = 0; i < machine.calls.size(); ++i) {
    const CallDefinition& call = machine.calls[i];
    const StateDefinition& state = machine.states[call.state];
    if (state.ends != BehaviorEnd::none)
      errors.push_back({call.position, title(state) + " ends the behavior, so it cannot run another one", state.file});
    for (std::size_t j = 0; j < i; ++j) {
      const CallDefinition& other = machine.calls[j];
      const bool is_same_path =
          machine.is_within(call.state, other.state) || machine.is_within(other.state, call.state);
      if (other.behavior != call.behavior || !is_same_path) continue;
      errors.push_back(
          {call.position,
           title(state) + ": " + in_quotes(call.behavior) + " already runs in " + title(machine.states[other.state]),
           state.file});
      break;
    }
  }
}

/// A behavior can only be awaited from a state that runs it, from an inner or an outer one.
void check_awaited(const MachineDefinition& machine, const TransitionDefinition& transition,
                   std::vector<DeclarationError>& errors) {
  if (transition.awaits.empty()) return;
  std::vector<std::string> names;
  for (const CallDefinition& call : machine.calls) {
    names.push_back(call.behavior);
    const bool is_near =
        machine.is_within(call.state, transition.from) || machine.is_within(transition.from, call.state);
    if (call.behavior == transition.awaits && is_near) return;
  }
  const StateDefinition& from = machine.states[transition.from];
  errors.push_back({transition.position,
                    title(from) + " awaits " + in_quotes(transition.awaits) + ", which it does not run" +
                        did_you_mean(transition.awaits, names),
                    from.file});
}

void check_end(const StateDefinition& state, std::vector<DeclarationError>& errors) {
  if (state.ends == BehaviorEnd::none) return;
  if (state.path.empty()) errors.push_back({state.position, "ends: expected in a state", state.file});
  if (!state.children.empty())
    errors.push_back({state.position, title(state) + " ends the behavior, so it cannot have inner states", state.file});
  if (!state.transitions.empty())
    errors.push_back({state.position, title(state) + " ends the behavior, so it cannot have transitions", state.file});
}

}  // namespace

std::string_view to_string(BehaviorEnd outcome) {
  switch (outcome) {
    case BehaviorEnd::none:
      return "running";
    case BehaviorEnd::done:
      return "done";
    case BehaviorEnd::failed:
      return "failed";
  }
  return "";
}

int MachineDefinition::find(const std::string& path) const {
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i].path == path) return static_cast<int>(i);
  }
  return -1;
}

bool MachineDefinition::is_within(int state, int ancestor) const {
  while (state > ancestor) state = states[state].parent;  // parents are before children
  return state == ancestor;
}

void intern_names(MachineDefinition& machine, Names& names) {
  machine.name_id = names.intern(machine.name);
  if (!machine.caller.empty()) machine.left_id = names.intern("its caller has left the state");
  for (StateDefinition& state : machine.states) {
    state.path_id = names.intern(state.path);
    if (!state.publishes.empty()) state.publishes_id = names.intern(state.publishes);
  }
  for (TransitionDefinition& transition : machine.transitions) transition.because_id = names.intern(transition.because);
}

std::vector<DeclarationError> resolve(MachineDefinition& machine) {
  std::vector<DeclarationError> errors;
  for (StateDefinition& state : machine.states) {
    check_duplicates(machine, state, errors);
    resolve_initial(machine, state, errors);
    check_end(state, errors);
  }
  check_calls(machine, errors);
  std::map<std::string, int> ordinals;
  for (TransitionDefinition& transition : machine.transitions) {
    resolve_transition(machine, transition, errors);
    check_awaited(machine, transition, errors);
    const std::string key = machine.states[transition.from].path + " -> " + transition.target;
    transition.key = key + " #" + std::to_string(ordinals[key]++);
  }
  std::stable_sort(errors.begin(), errors.end(),
                   [](const auto& a, const auto& b) { return is_before(a.position, b.position); });
  return errors;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "workbench/script_tools/graph/machine_json.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "workbench/script_tools/graph/condition_fields.h"

namespace reorient {
namespace {

using GraphJson = nlohmann::ordered_json;

std::string graph_text(const GraphJson& json) { return json.dump(-1, ' ', false, GraphJson::error_handler_t::replace); }

GraphJson state_json(const StateDefinition& state) {
  return {{"path", state.path},       {"name", state.name},         {"outer", state.parent},
          {"initial", state.initial}, {"history", state.history},   {"publishes", state.publishes},
          {"file", state.file},       {"line", state.position.line}};
}

/// Empty for a state that does not end its behavior.
std::string end_text(const StateDefinition& state) {
  return state.ends == BehaviorEnd::none ? std::string() : std::string(to_string(state.ends));
}

GraphJson transition_json(const TransitionDefinition& transition, const std::string& file, ConditionFields& fields) {
  return {{"from", transition.from},
          {"to", transition.to},
          {"reason", transition.because},
          {"common", transition.common},
          {"when", transition.when != LUA_NOREF},
          {"lasting", transition.lasting.text},
          {"after", transition.after.text},
          {"file", file},
          {"line", transition.position.line},
          {"maker", transition.maker},
          {"reads", fields.read_at(file, transition.position)}};
}

GraphJson graph_json(const MachineDefinition& machine, ConditionFields& fields) {
  GraphJson states = GraphJson::array(), transitions = GraphJson::array();
  GraphJson calls = GraphJson::array();
  for (const CallDefinition& call : machine.calls)
    calls.push_back({{"state", call.state}, {"behavior", call.behavior}, {"line", call.position.line}});
  for (const StateDefinition& state : machine.states) {
    states.push_back(state_json(state));
    states.back()["ends"] = end_text(state);
    for (const int index : state.transitions)
      transitions.push_back(transition_json(machine.transitions[static_cast<std::size_t>(index)], state.file, fields));
  }
  return {{"name", machine.name},          {"file", machine.file},
          {"line", machine.position.line}, {"scenario", machine.is_scenario},
          {"states", std::move(states)},   {"transitions", std::move(transitions)},
          {"calls", std::move(calls)}};
}

}  // namespace

std::string machine_json(const MachineDefinition& machine, const ScriptTexts& texts) {
  ConditionFields fields(texts);
  return graph_text(graph_json(machine, fields));
}

std::string to_json(std::span<const MachineDefinition> machines, std::span<const MachineLink> links,
                    const ScriptTexts& texts) {
  ConditionFields fields(texts);
  GraphJson drawn = GraphJson::array(), arrows = GraphJson::array();
  for (const MachineDefinition& machine : machines) drawn.push_back(graph_json(machine, fields));
  for (const MachineLink& link : links) {
    arrows.push_back({{"from_machine", link.from_machine},
                      {"from_state", link.from_state},
                      {"to_machine", link.to_machine},
                      {"to_state", link.to_state},
                      {"label", link.label}});
  }
  return graph_text({{"machines", std::move(drawn)}, {"links", std::move(arrows)}}) + "\n";
}

}  // namespace reorient

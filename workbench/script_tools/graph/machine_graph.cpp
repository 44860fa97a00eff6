// SPDX-License-Identifier: MIT
#include "workbench/script_tools/graph/machine_graph.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <set>
#include <string_view>
#include <utility>

#include "engine/parameters/utf8.h"
#include "workbench/script_tools/graph/script_sights.h"

namespace reorient {
namespace {

std::string with(std::string text, char from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, 1, to);
  return text;
}

/// Whether the text ends with the word that, before a blank and LR or TB, makes Mermaid read a whole line as the
/// direction of the diagram, wherever it is in the line.
bool ends_with_direction(std::string_view text) {
  constexpr std::string_view kWord = "direction";
  return text.size() >= kWord.size() &&
         std::equal(kWord.rbegin(), kWord.rend(), text.rbegin(),
                    [](char a, unsigned char b) { return a == static_cast<char>(std::tolower(b)); });
}

/// The text as Mermaid shows it: all characters that may have a meaning in its grammar, in its directives, in Markdown
/// or in HTML are entity codes.
std::string mermaid_text(const std::string& text) {
  constexpr std::string_view kPlain = " _.,()[]=+/-'?!";
  std::string out;
  for (const char letter : as_line(text)) {
    const auto code = static_cast<unsigned char>(letter);
    const bool is_plain = code >= 0x80 || std::isalnum(code) != 0 || kPlain.find(letter) != std::string_view::npos;
    if (is_plain && !(letter == ' ' && ends_with_direction(out))) {
      out += letter;
    } else {
      out += "#" + std::to_string(code) + ";";
    }
  }
  return out.empty() ? "#32;" : out;  // a label must not be empty
}

std::string mermaid_label(const std::string& text) { return '"' + mermaid_text(text) + '"'; }

/// The text in quotes, for Graphviz.
std::string dot_text(const std::string& text) {
  return '"' + with(with(as_line(text), '\\', "\\\\"), '"', "\\\"") + '"';
}

/// The reason and the dwell times.
std::string transition_label(const TransitionDefinition& transition) {
  std::string text = transition.because;
  if (transition.lasting.kind != Dwell::Kind::none) text += " [for " + transition.lasting.text + "]";
  const std::string after = "after " + transition.after.text;
  if (transition.after.kind != Dwell::Kind::none && text != after) text += " [" + after + "]";
  return text;
}

/// One machine of a picture. Its identifiers consist of letters, digits and _, and are unique in the picture.
struct DrawnMachine {
  const MachineDefinition& machine;
  std::string id;
  std::vector<std::string> states;     ///< identifiers; state 0: the node "any state"
  std::vector<std::string> starts;     ///< the dots at the start of the arrows to initial states
  bool has_common_transition = false;  ///< some transition belongs to the machine itself and leaves any state
};

/// Letters, digits and _ for a text such as "player/walk_to".
std::string identifier(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) == 0 || c >= 128; }, '_');
  return text;
}

std::vector<DrawnMachine> drawn_machines(std::span<const MachineDefinition> machines) {
  std::set<std::string> taken;
  const auto fresh = [&](const std::string& base) {
    std::string name = base;
    for (int i = 2; !taken.insert(name).second; ++i) name = base + "_" + std::to_string(i);
    return name;
  };
  std::vector<DrawnMachine> all;
  for (const MachineDefinition& machine : machines) {
    const std::string name = identifier(machine.name);
    const std::string prefix = name + "_";  // a state's name alone may be a keyword
    DrawnMachine drawn{machine, fresh(name + "_machine"), {}, {}};
    for (const StateDefinition& state : machine.states)
      drawn.states.push_back(fresh(prefix + identifier(state.path.empty() ? "any_state" : state.path)));
    for (std::size_t i = 0; i < machine.states.size(); ++i)
      drawn.starts.push_back(fresh((i == 0 ? prefix : drawn.states[i] + "_") + "start"));
    for (const TransitionDefinition& transition : machine.transitions)
      drawn.has_common_transition |= transition.from == 0;
    all.push_back(std::move(drawn));
  }
  return all;
}

void add_states_of_diagram(std::string& out, const DrawnMachine& drawn, int outer, const std::string& indent) {
  const StateDefinition& state = drawn.machine.states[outer];
  if (state.initial >= 0) out += indent + "[*] --> " + drawn.states[state.initial] + "\n";
  for (const int child : state.children) {
    const StateDefinition& inner = drawn.machine.states[child];
    out += indent + "state \"" + mermaid_text(inner.name) + "\" as " + drawn.states[child] + "\n";
    if (inner.children.empty()) continue;
    out += indent + "state " + drawn.states[child] + " {\n";
    add_states_of_diagram(out, drawn, child, indent + "  ");
    out += indent + "}\n";
  }
}

std::string state_diagram(const DrawnMachine& drawn) {
  std::string out = "stateDiagram-v2\n";
  add_states_of_diagram(out, drawn, 0, "  ");
  if (drawn.has_common_transition) out += "  state \"any state\" as " + drawn.states[0] + "\n";
  for (const TransitionDefinition& transition : drawn.machine.transitions) {
    out += "  " + drawn.states[transition.from] + " --> " + drawn.states[transition.to] + " : " +
           mermaid_text(transition_label(transition)) + "\n";
  }
  return out;
}

void add_states_of_chart(std::string& out, const DrawnMachine& drawn, int outer, const std::string& indent) {
  const StateDefinition& state = drawn.machine.states[outer];
  if (state.initial >= 0) out += indent + drawn.starts[outer] + "((\" \")) --> " + drawn.states[state.initial] + "\n";
  for (const int child : state.children) {
    const StateDefinition& inner = drawn.machine.states[child];
    if (inner.children.empty()) {
      out += indent + drawn.states[child] + "(" + mermaid_label(inner.name) + ")\n";
      continue;
    }
    out += indent + "subgraph " + drawn.states[child] + "[" + mermaid_label(inner.name) + "]\n";
    add_states_of_chart(out, drawn, child, indent + "  ");
    out += indent + "end\n";
  }
}

std::string flowchart(std::span<const DrawnMachine> machines, std::span<const MachineLink> links) {
  std::string out = "flowchart TB\n";
  for (const DrawnMachine& drawn : machines) {
    out += "  subgraph " + drawn.id + "[" + mermaid_label(drawn.machine.name) + "]\n";
    if (drawn.has_common_transition) out += "    " + drawn.states[0] + "([\"any state\"])\n";
    add_states_of_chart(out, drawn, 0, "    ");
    for (const TransitionDefinition& transition : drawn.machine.transitions) {
      out += "    " + drawn.states[transition.from] + " -->|" + mermaid_label(transition_label(transition)) + "| " +
             drawn.states[transition.to] + "\n";
    }
    out += "  end\n";
  }
  const auto end = [&](int machine, int state) {
    return state == 0 ? machines[machine].id : machines[machine].states[state];
  };
  for (const MachineLink& link : links) {
    out += "  " + end(link.from_machine, link.from_state) + " -.->|" + mermaid_label(link.label) + "| " +
           end(link.to_machine, link.to_state) + "\n";
  }
  return out;
}

void add_states_of_digraph(std::string& out, const DrawnMachine& drawn, int outer, const std::string& indent) {
  for (const int child : drawn.machine.states[outer].children) {
    const StateDefinition& inner = drawn.machine.states[child];
    const std::string label = "label=" + dot_text(inner.name);
    if (inner.children.empty()) {
      out.append(indent).append(drawn.states[child]).append(" [").append(label).append("];\n");
      continue;
    }
    const std::string inside = indent + "  ";
    out.append(indent).append("subgraph cluster_").append(drawn.states[child]).append(" {\n");
    out.append(inside).append(label).append(";\n");
    add_states_of_digraph(out, drawn, child, inside);
    out += indent + "}\n";
  }
}

/// Graphviz draws edges only between nodes, and clips them at the border of the given cluster.
struct DotEnd {
  std::string node;
  std::string cluster;  ///< empty: the edge ends at the node itself
};

/// State 0 stands for the machine's cluster.
DotEnd dot_end(const DrawnMachine& drawn, int state) {
  int inner = state;
  while (drawn.machine.states[inner].initial >= 0) inner = drawn.machine.states[inner].initial;
  if (inner == 0) return {drawn.starts[0], drawn.id};  // a machine without states
  if (state == 0) return {drawn.states[inner], drawn.id};
  return {drawn.states[inner], inner == state ? "" : drawn.states[state]};
}

/// Each attribute must begin with a comma.
std::string dot_edge(const DotEnd& from, const DotEnd& to, std::string attributes) {
  if (!from.cluster.empty()) attributes += ", ltail=cluster_" + from.cluster;
  if (!to.cluster.empty()) attributes += ", lhead=cluster_" + to.cluster;
  if (!attributes.empty()) attributes = " [" + attributes.substr(2) + "]";
  return from.node + " -> " + to.node + attributes + ";\n";
}

/// In a picture of several machines, only links are dashed.
void add_machine_to_digraph(std::string& out, const DrawnMachine& drawn, bool is_one) {
  const std::string indent = is_one ? "  " : "    ";
  const std::string common = is_one ? ", style=dashed" : "";
  out += indent + drawn.starts[0] + " [shape=point" + (is_one ? "" : ", label=\"\"") + "];\n";
  if (drawn.has_common_transition)
    out += indent + drawn.states[0] + " [label=\"any state\", style=\"rounded,dashed\"];\n";
  add_states_of_digraph(out, drawn, 0, indent);
  if (const int initial = drawn.machine.states[0].initial; initial >= 0)
    out += indent + dot_edge({drawn.starts[0], ""}, dot_end(drawn, initial), "");
  for (const TransitionDefinition& transition : drawn.machine.transitions) {
    const DotEnd from = transition.from == 0 ? DotEnd{drawn.states[0], ""} : dot_end(drawn, transition.from);
    out += indent + dot_edge(from, dot_end(drawn, transition.to),
                             ", label=" + dot_text(transition_label(transition)) + (transition.common ? common : ""));
  }
}

}  // namespace

std::vector<MachineLink> machine_links(std::span<const MachineDefinition> machines, const ScriptTexts& texts) {
  std::vector<MachineLink> links;
  const int count = static_cast<int>(machines.size());
  for (int caller = 0; caller < count; ++caller) {
    for (const CallDefinition& call : machines[caller].calls) {
      for (int callee = 0; callee < count; ++callee) {
        if (machines[callee].caller == machines[caller].name && machines[callee].behavior() == call.behavior)
          links.push_back({caller, call.state, callee, 0, "runs"});
      }
    }
  }
  const auto add_links_of = [&](const Sight& sight, int to_machine, int to_state) {
    for (int from = 0; from < count; ++from) {
      const MachineDefinition& machine = machines[from];
      if (from == to_machine || machine.is_scenario) continue;  // behaviors cannot read the states of a scenario
      for (int state = 0; state < static_cast<int>(machine.states.size()); ++state) {
        const bool is_seen = sight.machine.empty()
                                 ? machine.states[state].publishes == sight.field
                                 : machine.name == sight.machine && state == std::max(machine.find(sight.state), 0);
        if (is_seen) links.push_back({from, state, to_machine, to_state, sight.field});
      }
    }
  };
  for (int machine = 0; machine < count; ++machine) {
    for (const auto& [state, sights] : sights_of(machines[machine], texts)) {
      for (const Sight& sight : sights) add_links_of(sight, machine, state);
    }
  }
  return links;
}

std::string to_mermaid(std::span<const MachineDefinition> machines, std::span<const MachineLink> links) {
  const std::vector<DrawnMachine> drawn = drawn_machines(machines);
  return drawn.size() == 1 ? state_diagram(drawn.front()) : flowchart(drawn, links);
}

std::string to_dot(std::span<const MachineDefinition> machines, std::span<const MachineLink> links) {
  const std::vector<DrawnMachine> drawn = drawn_machines(machines);
  const bool is_one = drawn.size() == 1;
  std::string out = "digraph " + (is_one ? dot_text(machines.front().name) : "machines") +
                    " {\n  compound=true;\n  node [shape=box, style=rounded];\n";
  for (const DrawnMachine& machine : drawn) {
    if (!is_one) out += "  subgraph cluster_" + machine.id + " {\n    label=" + dot_text(machine.machine.name) + ";\n";
    add_machine_to_digraph(out, machine, is_one);
    if (!is_one) out += "  }\n";
  }
  for (const MachineLink& link : links) {
    out += "  " + dot_edge(dot_end(drawn[link.from_machine], link.from_state),
                           dot_end(drawn[link.to_machine], link.to_state),
                           ", label=" + dot_text(link.label) + ", style=dashed, constraint=false");
  }
  return out + "}\n";
}

}  // namespace reorient

#include "workbench/script_tools/graph/machine_graph.h"

#include <algorithm>

#include "workbench/script_tools/graph/graph_text.h"

namespace reorient {
namespace {

/// One identifier a state: its path in letters, digits and _; numbered where two paths would become the same.
std::vector<std::string> identifiers(const MachineDefinition& machine) {
  std::vector<std::string> all;
  for (const StateDefinition& state : machine.states) {
    std::string id = state_identifier(state);
    if (std::find(all.begin(), all.end(), id) != all.end()) id += "_" + std::to_string(all.size());
    all.push_back(std::move(id));
  }
  return all;
}

struct MermaidWriter {
  const MachineDefinition& machine;
  std::vector<std::string> id;
  std::string out;

  void write_states(int index, const std::string& indent) {
    const StateDefinition& state = machine.states[index];
    if (state.initial >= 0) out += indent + "[*] --> " + id[state.initial] + "\n";
    for (const int child : state.children) {
      const StateDefinition& inner = machine.states[child];
      out += indent + "state \"" + mermaid_text(inner.name) + "\" as " + id[child] + "\n";
      if (inner.children.empty()) continue;
      out += indent + "state " + id[child] + " {\n";
      write_states(child, indent + "  ");
      out += indent + "}\n";
    }
  }
};

struct DotWriter {
  const MachineDefinition& machine;
  std::vector<std::string> id;
  std::string out;

  void write_states(int index, const std::string& indent) {
    for (const int child : machine.states[index].children) {
      const StateDefinition& inner = machine.states[child];
      if (inner.children.empty()) {
        out += indent + id[child] + " [label=" + dot_text(inner.name) + "];\n";
        continue;
      }
      out.append(indent).append("subgraph cluster_").append(id[child]).append(" {\n");
      out.append(indent).append("  label=").append(dot_text(inner.name)).append(";\n");
      write_states(child, indent + "  ");
      out += indent + "}\n";
    }
  }

  int innermost(int state) const { return innermost_state(machine, state); }

  /// An edge of a cluster is cut off at its border.
  std::string ends(int from, int to) const {
    std::string cut;
    if (from != 0 && from != innermost(from)) cut += ", ltail=cluster_" + id[from];
    if (to != innermost(to)) cut += ", lhead=cluster_" + id[to];
    return cut;
  }
};

}  // namespace

std::string to_mermaid(const MachineDefinition& machine) {
  MermaidWriter writer{machine, identifiers(machine), "stateDiagram-v2\n"};
  writer.write_states(0, "  ");
  if (has_common_way(machine)) writer.out += "  state \"any state\" as " + writer.id[0] + "\n";
  for (const TransitionDefinition& transition : machine.transitions) {
    writer.out += "  " + writer.id[transition.from] + " --> " + writer.id[transition.to] + " : " +
                  mermaid_text(transition_label(transition)) + "\n";
  }
  return writer.out;
}

std::string to_dot(const MachineDefinition& machine) {
  DotWriter writer{machine, identifiers(machine), "digraph " + dot_text(machine.name) + " {\n"};
  std::string& out = writer.out;
  out += "  compound=true;\n  node [shape=box, style=rounded];\n  start [shape=point];\n";
  if (has_common_way(machine)) out += "  " + writer.id[0] + " [label=\"any state\", style=\"rounded,dashed\"];\n";
  writer.write_states(0, "  ");
  if (const int initial = machine.states[0].initial; initial >= 0) {
    const std::string cut = writer.ends(0, initial);
    out +=
        "  start -> " + writer.id[writer.innermost(initial)] + (cut.empty() ? "" : " [" + cut.substr(2) + "]") + ";\n";
  }
  for (const TransitionDefinition& transition : machine.transitions) {
    const int from = transition.from == 0 ? 0 : writer.innermost(transition.from);
    out += "  " + writer.id[from] + " -> " + writer.id[writer.innermost(transition.to)] +
           " [label=" + dot_text(transition_label(transition)) + (transition.common ? ", style=dashed" : "") +
           writer.ends(transition.from, transition.to) + "];\n";
  }
  return out + "}\n";
}

}  // namespace reorient

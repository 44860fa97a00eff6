#include "workbench/script_tools/graph/machines_graph.h"

#include <algorithm>
#include <set>
#include <utility>

#include "workbench/script_tools/graph/graph_text.h"
#include "workbench/script_tools/graph/script_sights.h"

namespace reorient {
namespace {

class LinkSearch {
 public:
  explicit LinkSearch(std::span<const MachineDefinition> machines) : machines_(machines) {}

  void add(int to_machine, int to_state, const Sight& sight) {
    for (int from = 0; from < static_cast<int>(machines_.size()); ++from) {
      const MachineDefinition& machine = machines_[static_cast<std::size_t>(from)];
      if (from == to_machine || machine.is_scenario) continue;  // nobody sees a scenario
      if (sight.machine.empty()) {
        for (int state = 0; state < static_cast<int>(machine.states.size()); ++state) {
          if (machine.states[static_cast<std::size_t>(state)].publishes == sight.field)
            links.push_back({from, state, to_machine, to_state, sight.field});
        }
      } else if (machine.name == sight.machine) {
        const int state = sight.state.empty() ? 0 : std::max(machine.find(sight.state), 0);
        links.push_back({from, state, to_machine, to_state, sight.field});
      }
    }
  }

  std::vector<MachineLink> links;

 private:
  std::span<const MachineDefinition> machines_;
};

/// Of all that is drawn: each once.
class Identifiers {
 public:
  explicit Identifiers(std::span<const MachineDefinition> machines) {
    for (const MachineDefinition& machine : machines) {
      std::vector<std::string>& states = states_.emplace_back();
      std::vector<std::string>& starts = starts_.emplace_back();
      machines_.push_back(fresh(machine.name + "_machine"));
      for (const StateDefinition& state : machine.states) {
        states.push_back(fresh(machine.name + "_" + state_identifier(state)));
        starts.push_back(fresh((state.path.empty() ? machine.name : states.back()) + "_start"));
      }
    }
  }

  const std::string& machine(int index) const { return machines_[static_cast<std::size_t>(index)]; }
  /// Of state 0: the node that stands for any of them.
  const std::string& state(int machine, int state) const { return of(states_, machine, state); }
  /// The dot from which the arrow to its initial state leads.
  const std::string& start(int machine, int state) const { return of(starts_, machine, state); }

 private:
  using Lists = std::vector<std::vector<std::string>>;
  static const std::string& of(const Lists& lists, int machine, int state) {
    return lists[static_cast<std::size_t>(machine)][static_cast<std::size_t>(state)];
  }

  std::string fresh(const std::string& wanted) {
    std::string name = wanted;
    for (int i = 2; !taken_.insert(name).second; ++i) name = wanted + "_" + std::to_string(i);
    return name;
  }

  std::set<std::string> taken_;
  std::vector<std::string> machines_;
  Lists states_;
  Lists starts_;
};

/// In quotes: nothing in it is taken for markup.
std::string quoted(const std::string& text) {
  std::string out;
  for (const char letter : mermaid_text(text))
    out += letter == '<' ? "#lt;" : letter == '>' ? "#gt;" : letter == '`' ? "'" : std::string(1, letter);
  return '"' + out + '"';
}

class MermaidPicture {
 public:
  explicit MermaidPicture(std::span<const MachineDefinition> machines) : machines_(machines), id_(machines) {}

  std::string draw(std::span<const MachineLink> links) {
    for (int machine = 0; machine < static_cast<int>(machines_.size()); ++machine) draw_machine(machine);
    for (const MachineLink& link : links) {
      out_ += "  " + end(link.from_machine, link.from_state) + " -.->|" + quoted(link.label) + "| " +
              end(link.to_machine, link.to_state) + "\n";
    }
    return out_;
  }

 private:
  void draw_machine(int index) {
    const MachineDefinition& machine = machines_[static_cast<std::size_t>(index)];
    out_ += "  subgraph " + id_.machine(index) + "[" + quoted(machine.name) + "]\n";
    if (has_common_way(machine)) out_ += "    " + id_.state(index, 0) + "([\"any state\"])\n";
    draw_states(index, 0, "    ");
    for (const TransitionDefinition& transition : machine.transitions) {
      out_ += "    " + id_.state(index, transition.from) + " -->|" + quoted(transition_label(transition)) + "| " +
              id_.state(index, transition.to) + "\n";
    }
    out_ += "  end\n";
  }

  void draw_states(int index, int outer, const std::string& indent) {
    const MachineDefinition& machine = machines_[static_cast<std::size_t>(index)];
    const StateDefinition& state = machine.states[static_cast<std::size_t>(outer)];
    if (state.initial >= 0)
      out_ += indent + id_.start(index, outer) + "((\" \")) --> " + id_.state(index, state.initial) + "\n";
    for (const int child : state.children) {
      const StateDefinition& inner = machine.states[static_cast<std::size_t>(child)];
      const std::string& id = id_.state(index, child);
      if (inner.children.empty()) {
        out_ += indent + id + "(" + quoted(inner.name) + ")\n";
        continue;
      }
      out_.append(indent).append("subgraph ").append(id).append("[").append(quoted(inner.name)).append("]\n");
      draw_states(index, child, indent + "  ");
      out_ += indent + "end\n";
    }
  }

  const std::string& end(int machine, int state) const {
    return state == 0 ? id_.machine(machine) : id_.state(machine, state);
  }

  std::span<const MachineDefinition> machines_;
  Identifiers id_;
  std::string out_ = "flowchart TB\n";
};

class DotPicture {
 public:
  explicit DotPicture(std::span<const MachineDefinition> machines) : machines_(machines), id_(machines) {}

  std::string draw(std::span<const MachineLink> links) {
    for (int machine = 0; machine < static_cast<int>(machines_.size()); ++machine) draw_machine(machine);
    for (const MachineLink& link : links) {
      const End from = end(link.from_machine, link.from_state), to = end(link.to_machine, link.to_state);
      out_ += "  " + from.node + " -> " + to.node + " [label=" + dot_text(link.label) +
              ", style=dashed, constraint=false" + cut(", ltail=", from) + cut(", lhead=", to) + "];\n";
    }
    return out_ + "}\n";
  }

 private:
  /// An edge ends at a node, and is cut off at the border of the cluster that is meant.
  struct End {
    std::string node;
    std::string cluster;  ///< empty: the node itself is meant
  };

  static std::string cut(const std::string& key, const End& end) {
    return end.cluster.empty() ? "" : key + "cluster_" + end.cluster;
  }

  End end(int index, int state) const {
    const MachineDefinition& machine = machines_[static_cast<std::size_t>(index)];
    const int inner = innermost_state(machine, state);
    if (inner == 0) return {id_.start(index, 0), id_.machine(index)};  // a machine without states
    const std::string& node = id_.state(index, inner);
    if (state == 0) return {node, id_.machine(index)};
    return {node, inner == state ? "" : id_.state(index, state)};
  }

  void draw_machine(int index) {
    const MachineDefinition& machine = machines_[static_cast<std::size_t>(index)];
    out_ += "  subgraph cluster_" + id_.machine(index) + " {\n    label=" + dot_text(machine.name) + ";\n";
    out_ += "    " + id_.start(index, 0) + " [shape=point, label=\"\"];\n";
    if (has_common_way(machine))
      out_ += "    " + id_.state(index, 0) + " [label=\"any state\", style=\"rounded,dashed\"];\n";
    draw_states(index, 0, "    ");
    if (const int initial = machine.states[0].initial; initial >= 0) {
      const End to = end(index, initial);
      out_ += "    " + id_.start(index, 0) + " -> " + to.node +
              (to.cluster.empty() ? "" : " [lhead=cluster_" + to.cluster + "]") + ";\n";
    }
    for (const TransitionDefinition& transition : machine.transitions) {
      const End from = transition.from == 0 ? End{id_.state(index, 0), ""} : end(index, transition.from);
      const End to = end(index, transition.to);
      out_ += "    " + from.node + " -> " + to.node + " [label=" + dot_text(transition_label(transition)) +
              cut(", ltail=", from) + cut(", lhead=", to) + "];\n";
    }
    out_ += "  }\n";
  }

  void draw_states(int index, int outer, const std::string& indent) {
    const MachineDefinition& machine = machines_[static_cast<std::size_t>(index)];
    for (const int child : machine.states[static_cast<std::size_t>(outer)].children) {
      const StateDefinition& inner = machine.states[static_cast<std::size_t>(child)];
      const std::string& id = id_.state(index, child);
      if (inner.children.empty()) {
        out_ += indent + id + " [label=" + dot_text(inner.name) + "];\n";
        continue;
      }
      out_.append(indent).append("subgraph cluster_").append(id).append(" {\n");
      out_.append(indent).append("  label=").append(dot_text(inner.name)).append(";\n");
      draw_states(index, child, indent + "  ");
      out_ += indent + "}\n";
    }
  }

  std::span<const MachineDefinition> machines_;
  Identifiers id_;
  std::string out_ = "digraph machines {\n  compound=true;\n  node [shape=box, style=rounded];\n";
};

}  // namespace

std::vector<MachineLink> machine_links(std::span<const MachineDefinition> machines, const ScriptTexts& texts) {
  LinkSearch search(machines);
  for (int machine = 0; machine < static_cast<int>(machines.size()); ++machine) {
    for (const auto& [state, sights] : sights_of(machines[static_cast<std::size_t>(machine)], texts)) {
      for (const Sight& sight : sights) search.add(machine, state, sight);
    }
  }
  return std::move(search.links);
}

std::string to_mermaid(std::span<const MachineDefinition> machines, std::span<const MachineLink> links) {
  return MermaidPicture(machines).draw(links);
}

std::string to_dot(std::span<const MachineDefinition> machines, std::span<const MachineLink> links) {
  return DotPicture(machines).draw(links);
}

}  // namespace reorient

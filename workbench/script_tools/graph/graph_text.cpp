#include "workbench/script_tools/graph/graph_text.h"

#include <algorithm>
#include <cctype>

#include "engine/parameters/utf8.h"

namespace reorient {
namespace {

std::string with(std::string text, char from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, 1, to);
  return text;
}

}  // namespace

std::string state_identifier(const StateDefinition& state) {
  std::string id = state.path.empty() ? "any_state" : state.path;
  std::replace_if(
      id.begin(), id.end(), [](unsigned char c) { return std::isalnum(c) == 0 || c >= 128; }, '_');
  return id;
}

std::string transition_label(const TransitionDefinition& transition) {
  std::string text = transition.because;
  if (transition.lasting.kind != Dwell::Kind::none) text += " [for " + transition.lasting.text + "]";
  const std::string after = "after " + transition.after.text;
  if (transition.after.kind != Dwell::Kind::none && text != after) text += " [" + after + "]";
  return text;
}

std::string mermaid_text(const std::string& text) {
  return with(with(with(as_line(text), '#', "#35;"), '"', "'"), ':', "#58;");
}

std::string dot_text(const std::string& text) {
  return '"' + with(with(as_line(text), '\\', "\\\\"), '"', "\\\"") + '"';
}

bool has_common_way(const MachineDefinition& machine) {
  return std::any_of(machine.transitions.begin(), machine.transitions.end(),
                     [](const TransitionDefinition& transition) { return transition.from == 0; });
}

int innermost_state(const MachineDefinition& machine, int state) {
  while (machine.states[state].initial >= 0) state = machine.states[state].initial;
  return state;
}

}  // namespace reorient

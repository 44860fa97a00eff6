// SPDX-License-Identifier: MIT
#include "workbench/script_tools/reference/behavior_page.h"

#include <stdexcept>

#include "workbench/script_tools/graph/machine_graph.h"

namespace reorient {
namespace {

std::string replaced(const std::string& page, const std::string& part, const std::string& text) {
  const std::string begin_mark = "<!-- generated: " + part + " -->\n";
  const std::size_t begin = page.find(begin_mark);
  const std::size_t end = begin == std::string::npos ? begin : page.find("<!-- end -->", begin);
  if (end == std::string::npos) throw std::runtime_error("the page: missing " + begin_mark + "<!-- end -->");
  return page.substr(0, begin + begin_mark.size()) + text + page.substr(end);
}

std::string table(const std::string& what, std::span<const ParameterDeclaration> parameters) {
  if (parameters.empty()) return "None.\n";
  std::string text = "| " + what + " | default | range | what it is |\n|---|---|---|---|\n";
  for (const ParameterDeclaration& parameter : parameters) {
    text += "| `" + parameter.name + "` | " + to_text(parameter.default_value) + " | " + range_text(parameter) + " | " +
            parameter.description + " |\n";
  }
  return text;
}

}  // namespace

std::string with_generated_parts(const std::string& page, const MachineDefinition& machine,
                                 std::span<const ParameterDeclaration> parameters,
                                 std::span<const ParameterDeclaration> arguments) {
  const std::string states = "```mermaid\n" + to_mermaid({&machine, 1}) + "```\n";
  const std::string text = replaced(replaced(page, "states", states), "parameters", table("parameter", parameters));
  return arguments.empty() ? text : replaced(text, "arguments", table("argument", arguments));
}

}  // namespace reorient

// `reorient graph`: state machines as pictures for Mermaid or Graphviz.
#include <initializer_list>
#include <memory>
#include <ostream>
#include <stdexcept>

#include "engine/parameters/nearest_name.h"
#include "engine/script/language/behavior_language.h"
#include "engine/script/script_host.h"
#include "program/options.h"
#include "program/program.h"
#include "program/subcommand.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/script_files.h"
#include "workbench/scenario/scenario_language.h"
#include "workbench/script_tools/graph/machine_graph.h"

namespace reorient {
namespace {

struct GraphOptions {
  std::string script;
  std::filesystem::path scripts;
  std::string format = "mermaid";
  std::filesystem::path out;
};

std::string draw(const MachineDefinition& machine, const std::string& format) {
  return format == "dot" ? to_dot(machine) : to_mermaid(machine);
}

/// "orientation" or "turned_round": whichever of a behaviour and a scenario there is; the behaviour first.
std::string draw_script(const std::filesystem::path& root, const GraphOptions& options) {
  const ScriptTexts texts = read_scripts(root);
  const std::string wanted = script_named(root, options.script);
  std::vector<std::string> known;
  BehaviorLanguage behaviors;
  ScenarioLanguage scenarios;
  for (ScriptLanguage* language : std::initializer_list<ScriptLanguage*>{&behaviors, &scenarios}) {
    for (const std::string& file : texts.in_folder(language->folder())) {
      known.push_back(std::filesystem::path(file).stem().string());
      if (known.back() != wanted && file != wanted) continue;
      ParameterRegistry parameters;
      ScriptHost host(texts, *language, parameters);
      host.load(file);
      std::string text;
      for (const MachineDefinition* machine : host.definitions()) text += draw(*machine, options.format);
      return text;
    }
  }
  throw std::runtime_error("there is no behavior or scenario '" + options.script + "' below " + root.string() +
                           did_you_mean(options.script, known));
}

int graph(const GraphOptions& options, std::ostream& out) {
  const std::string text = draw_script(scripts_root(options.scripts), options);
  if (options.out.empty()) {
    out << text;
  } else {
    write_whole_file(options.out, text);
  }
  return kSuccess;
}

}  // namespace

Subcommand add_graph(CLI::App& program) {
  const auto options = std::make_shared<GraphOptions>();
  CLI::App* const parser =
      program.add_subcommand("graph", "draw a script's states, for Mermaid or Graphviz")->fallthrough();
  parser->add_option("script", options->script, "name of a behavior or scenario, or its file")->required();
  parser->add_option("--format", options->format, "mermaid (README files show it) or dot (Graphviz)")
      ->check(CLI::IsMember({"mermaid", "dot"}))
      ->capture_default_str();
  parser->add_option("--out", options->out, "write into this file, not to the terminal");
  add_scripts_option(*parser, options->scripts);
  return {parser, [options](std::ostream& out, std::ostream&) { return graph(*options, out); }};
}

}  // namespace reorient

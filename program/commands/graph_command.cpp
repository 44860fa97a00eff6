// `reorient graph`: state machines as pictures for Mermaid or Graphviz.
#include <memory>
#include <ostream>
#include <stdexcept>

#include "engine/parameters/nearest_name.h"
#include "engine/script/script_host.h"
#include "program/program.h"
#include "program/subcommand.h"
#include "program/tuning.h"
#include "workbench/files/atomic_file.h"
#include "workbench/script_tools/graph/machine_graph.h"

namespace reorient {
namespace {

struct GraphOptions {
  std::string script;
  std::filesystem::path scripts;
  std::string format = "mermaid";
  std::filesystem::path out;
};

/// "orientation" or "turned_round": whichever of a behaviour and a scenario there is; the behaviour first.
void load(ScriptHost& host, const std::filesystem::path& root, const std::string& name) {
  std::vector<std::string> known;
  for (const char* folder : {"behaviors", "scenarios"}) {
    for (const std::string& file : scripts_in(root, folder)) {
      const std::string stem = std::filesystem::path(file).stem().string();
      known.push_back(stem);
      const std::filesystem::path full = root / file;
      std::error_code error;
      if (stem != name && !std::filesystem::equivalent(full, name, error)) continue;
      if (folder == std::string("behaviors")) return host.load_behavior(full.string());
      return host.load_scenario(full.string());
    }
  }
  throw std::runtime_error("there is no behavior or scenario '" + name + "' below " + root.string() +
                           did_you_mean(name, known));
}

int draw(const GraphOptions& options, std::ostream& out) {
  const std::filesystem::path root = scripts_root(options.scripts);
  Tuning tuning;
  ScriptHost host(root, tuning.registry);
  load(host, root, options.script);
  std::string text;
  // A scenario comes with its behaviours; wanted is the script that was named.
  const std::vector<const MachineDefinition*> machines = host.definitions();
  for (const MachineDefinition* machine : machines) {
    if (std::filesystem::path(machine->file).stem() != std::filesystem::path(options.script).stem()) continue;
    text += options.format == "dot" ? to_dot(*machine) : to_mermaid(*machine);
  }
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
  return {parser, [options](std::ostream& out, std::ostream&) { return draw(*options, out); }};
}

}  // namespace reorient

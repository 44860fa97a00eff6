// SPDX-License-Identifier: MIT
// `reorient graph`: state machines as pictures for Mermaid or Graphviz, or as JSON.
#include <algorithm>
#include <initializer_list>
#include <memory>
#include <ostream>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "engine/parameters/nearest_name.h"
#include "engine/script/language/behavior_language.h"
#include "engine/script/script_host.h"
#include "program/help.h"
#include "program/named_files.h"
#include "program/options.h"
#include "program/program.h"
#include "program/script_names.h"
#include "program/subcommand.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/interface_file.h"
#include "workbench/files/script_files.h"
#include "workbench/scenario/scenario_language.h"
#include "workbench/script_tools/graph/machine_graph.h"
#include "workbench/script_tools/graph/machine_json.h"

namespace reorient {
namespace {

struct GraphOptions {
  std::vector<std::string> scripts;
  bool with_behaviors = false;
  std::filesystem::path scripts_root;
  std::string format = "mermaid";
  std::filesystem::path out;
};

struct NamedScript {
  std::string file;
  ScriptKind kind = ScriptKind::behavior;

  bool operator==(const NamedScript&) const = default;
};

/// The requested scripts, as found below the root, and their machines.
class DrawnScripts {
 public:
  explicit DrawnScripts(const std::filesystem::path& root)
      : root_(root), texts_(read_scripts(root)), application_(merged(known_interfaces(root))) {
    for (const ScriptLanguage* language : std::initializer_list<const ScriptLanguage*>{&behaviors_, &scenarios_}) {
      for (const std::string& file : texts_.in_folder(language->folder())) all_.push_back({file, language->kind()});
    }
  }

  const ScriptTexts& texts() const { return texts_; }
  const std::vector<MachineDefinition>& machines() const { return machines_; }

  /// "orientation", "behaviors/orientation.lua", or a path to that file. Each once.
  void add(const std::string& name) { add(find(name)); }

  /// Throws std::runtime_error if none of them is a scenario.
  void add_behaviors_of_scenarios() {
    std::vector<std::string> behaviors;
    bool has_scenario = false;
    for (const MachineDefinition& machine : machines_) {
      has_scenario |= machine.is_scenario;
      behaviors.insert(behaviors.end(), machine.behaviors.begin(), machine.behaviors.end());
    }
    if (!has_scenario) throw std::runtime_error("--with-behaviors: expected a scenario, found behaviors only");
    for (const std::string& behavior : behaviors)
      add({script_file(behaviors_.folder(), behavior), ScriptKind::behavior});
  }

 private:
  NamedScript find(const std::string& name) const {
    const std::string wanted = script_named(root_, name);
    std::vector<NamedScript> found, of_that_stem;
    std::vector<std::string> known;
    for (const NamedScript& script : all_) {
      const std::string_view folder = script.kind == ScriptKind::behavior ? behaviors_.folder() : scenarios_.folder();
      known.push_back(std::filesystem::path(script.file).stem().string());
      if (script.file == script_file(folder, wanted)) found.push_back(script);
      if (known.back() == wanted) of_that_stem.push_back(script);
    }
    if (found.empty()) found = std::move(of_that_stem);
    if (found.size() == 1) return found.front();
    if (found.empty()) require_no_other_file(root_, name);
    if (found.empty())
      throw std::runtime_error("unknown behavior or scenario '" + name + "' below " + root_.string() +
                               did_you_mean(name, known));
    throw std::runtime_error("'" + name + "': expected one script, found " + found[0].file + " and " + found[1].file +
                             "; name the file");
  }

  void add(const NamedScript& script) {
    if (std::find(added_.begin(), added_.end(), script) != added_.end()) return;
    added_.push_back(script);
    ScriptLanguage& language =
        script.kind == ScriptKind::behavior ? static_cast<ScriptLanguage&>(behaviors_) : scenarios_;
    ParameterRegistry parameters;
    ScriptHost host(texts_, language, parameters);
    host.load(script.file);
    for (const MachineDefinition* machine : host.definitions()) machines_.push_back(*machine);
  }

  std::filesystem::path root_;
  ScriptTexts texts_;
  ApplicationState application_;
  BehaviorLanguage behaviors_{application_};
  ScenarioLanguage scenarios_;
  std::vector<NamedScript> all_;
  std::vector<NamedScript> added_;
  std::vector<MachineDefinition> machines_;
};

int graph(const GraphOptions& options, std::ostream& out) {
  const std::filesystem::path root = scripts_root(options.scripts_root);
  require_writable_output(options.out, "--out", root);
  DrawnScripts scripts(root);
  for (const std::string& name : options.scripts) scripts.add(name);
  if (options.with_behaviors) scripts.add_behaviors_of_scenarios();
  const std::vector<MachineDefinition>& machines = scripts.machines();
  const std::vector<MachineLink> links = machine_links(machines, scripts.texts());
  const std::string text = options.format == "dot"    ? to_dot(machines, links)
                           : options.format == "json" ? to_json(machines, links, scripts.texts())
                                                      : to_mermaid(machines, links);
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
      program.add_subcommand("graph", "draw the state machines of scripts as Mermaid, Graphviz or JSON")->fallthrough();
  set_examples(*parser, {{"reorient graph orientation", "states and transitions of a behavior"},
                         {"reorient graph kidnapped --with-behaviors", "a scenario and the behaviors it loads"}});
  parser->add_option("scripts", options->scripts, "names of behaviors and scenarios, or files, for one drawing")
      ->type_name("SCRIPT")
      ->required();
  parser->add_flag("--with-behaviors", options->with_behaviors, "draw the behaviors that a scenario loads, too");
  parser->add_option("--format", options->format, "format: mermaid (shown by GitHub), dot (Graphviz) or json")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"mermaid", "dot", "json"}))
      ->capture_default_str();
  parser->add_option("--out", options->out, "file to write (default: the standard output)")->type_name("FILE");
  add_scripts_option(*parser, options->scripts_root, kPlainGroup);
  return {parser, [options](std::ostream& out, std::ostream&) { return graph(*options, out); }};
}

}  // namespace reorient

#include "workbench/script_tools/check/script_check.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "engine/script/script_error.h"
#include "engine/script/script_host.h"
#include "engine/script/source/source_locations.h"
#include "workbench/files/atomic_file.h"
#include "workbench/script_tools/check/machine_warnings.h"
#include "workbench/script_tools/check/name_check.h"

namespace reorient {
namespace {

using Severity = Finding::Severity;

auto order(const Finding& finding) {
  return std::tie(finding.file, finding.position.line, finding.position.column, finding.message);
}

class ScriptCheck {
 public:
  ScriptCheck(const std::filesystem::path& root, ParameterRegistry& registry) : root_(root), registry_(registry) {}

  CheckResult run() {
    const std::vector<std::string> behaviors = scripts_in(root_, "behaviors");
    const std::vector<std::string> scenarios = scripts_in(root_, "scenarios");
    load_together(behaviors);
    for (const std::string& scenario : scenarios) load_with_behaviors(scenario);
    for (const std::string& file : behaviors) look_at_names(file, ScriptRole::behavior);
    for (const std::string& file : scenarios) look_at_names(file, ScriptRole::scenario);
    for (const std::string& file : scripts_in(root_, "lib")) look_at_names(file, ScriptRole::library);
    for (const std::string& file : scripts_in(root_, "tests")) look_at_names(file, ScriptRole::test);
    std::vector<Finding>& all = result_.findings;
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return order(a) < order(b); });
    // A behaviour that several scenarios load is told once.
    all.erase(std::unique(all.begin(), all.end(), [](const auto& a, const auto& b) { return order(a) == order(b); }),
              all.end());
    return std::move(result_);
  }

 private:
  void note(const ScriptError& error) {
    for (const ScriptFault& fault : error.all)
      result_.findings.push_back({Severity::error, fault.file, {fault.line, fault.column}, fault.message});
  }

  void load_together(const std::vector<std::string>& behaviors) {
    ScriptHost host(root_, registry_);
    for (const std::string& file : behaviors) {
      try {
        host.load_behavior((root_ / file).string());
      } catch (const ScriptError& error) {
        note(error);
        knows_all_machines_ = false;
      }
    }
    take_in(host);
    for (const MachineDefinition* machine : host.definitions()) {
      std::set<std::string>& states = states_[machine->name];
      for (const StateDefinition& state : machine->states) states.insert(state.path);
    }
  }

  void load_with_behaviors(const std::string& scenario) {
    ScriptHost host(root_, registry_);
    try {
      host.load_scenario((root_ / scenario).string());
    } catch (const ScriptError& error) {
      note(error);
    }
    take_in(host);
  }

  void take_in(const ScriptHost& host) {
    for (const MachineDefinition* machine : host.definitions()) {
      for (DeclarationError& warning : machine_warnings(*machine))
        result_.findings.push_back({Severity::warning, machine->file, warning.position, std::move(warning.message)});
    }
    for (auto& [module, fields] : host.module_fields()) modules_[module] = {fields, {}, false};
  }

  void look_at_names(const std::string& file, ScriptRole role) {
    ++result_.files;
    const std::optional<std::string> text = read_whole_file(root_ / file);
    const bool is_loaded_before = role == ScriptRole::behavior || role == ScriptRole::scenario;
    if (!text || (text->size() > kLargestScript && role != ScriptRole::test)) {
      // The loader has said so of what it met.
      if (!is_loaded_before) result_.findings.push_back({Severity::error, file, {}, "this script cannot be read"});
      return;
    }
    Sandbox sandbox{ScriptLimits{}};
    if (std::optional<ScriptFault> fault = sandbox.compile(*text, file)) {
      // As the loader tells it, which may have met the file as well: then it is told once.
      const int column = SourceLocations(*text).column_of_syntax_error(fault->message, fault->line);
      result_.findings.push_back({Severity::error, file, {fault->line, column}, fault->message});
      return;
    }
    SymbolTable known = symbol_table(role);
    known.modules = modules_;
    if (knows_all_machines_) known.states = states_;
    for (DeclarationError& slip : check_names(*text, known))
      result_.findings.push_back({Severity::error, file, slip.position, std::move(slip.message)});
  }

  std::filesystem::path root_;
  ParameterRegistry& registry_;
  std::map<std::string, std::set<std::string>> states_;
  bool knows_all_machines_ = true;
  std::map<std::string, TableSymbol> modules_;
  CheckResult result_;
};

/// From the root; throws where the path is not below it.
std::string below(const std::filesystem::path& root, const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw std::runtime_error(path.string() + ": there is no such file or folder");
  const std::optional<std::string> relative = path_below(root, path);
  if (!relative)
    throw std::runtime_error(path.string() + " is not below " + root.string() + "; name its root with --scripts");
  return *relative;
}

}  // namespace

std::string Finding::text() const {
  return place_text(file, position.line, position.column) +
         (severity == Severity::error ? ": error: " : ": warning: ") + message;
}

int CheckResult::count(Finding::Severity severity) const {
  return static_cast<int>(std::count_if(findings.begin(), findings.end(),
                                        [severity](const Finding& finding) { return finding.severity == severity; }));
}

CheckResult check_scripts(const std::filesystem::path& scripts_root, std::span<const std::filesystem::path> paths,
                          ParameterRegistry& registry) {
  std::vector<std::string> wanted;
  for (const std::filesystem::path& path : paths) wanted.push_back(below(scripts_root, path));
  CheckResult result = ScriptCheck(scripts_root, registry).run();
  if (wanted.empty()) return result;
  std::erase_if(result.findings, [&](const Finding& finding) {
    return std::none_of(wanted.begin(), wanted.end(), [&](const std::string& path) {
      return path == "." || finding.file == path || finding.file.starts_with(path + "/");
    });
  });
  return result;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "workbench/script_tools/check/script_check.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "engine/core_parameters.h"
#include "engine/script/language/behavior_language.h"
#include "engine/script/script_error.h"
#include "engine/script/script_host.h"
#include "engine/script/source/source_locations.h"
#include "workbench/files/input_file.h"
#include "workbench/files/interface_file.h"
#include "workbench/files/script_files.h"
#include "workbench/scenario/scenario_language.h"
#include "workbench/script_tools/check/machine_warnings.h"
#include "workbench/script_tools/check/missing_values.h"
#include "workbench/script_tools/check/symbol_table.h"
#include "workbench/script_tools/check/text_check.h"

namespace reorient {
namespace {

using Severity = Finding::Severity;

constexpr std::string_view kExtension = ".lua";

auto order(const Finding& finding) {
  return std::tie(finding.file, finding.position.line, finding.position.column, finding.message);
}

TextsToCheck read_texts_to_check(const std::filesystem::path& root) {
  TextsToCheck texts{.scripts = read_scripts(root), .interfaces = known_interfaces(root)};
  for (const std::string& file : scripted_tests(root)) {
    try {
      texts.tests[file] = {read_input(root / file, "a scripted test"), ""};
    } catch (const std::runtime_error& reason) {
      texts.tests[file] = {"", reason.what()};
    }
  }
  return texts;
}

/// "lib/walk.lua" is required as "lib.walk".
std::string module_name(std::string file) {
  file.resize(file.size() - kExtension.size());
  std::replace(file.begin(), file.end(), '/', '.');
  return file;
}

std::string file_of(std::string module) {
  std::replace(module.begin(), module.end(), '.', '/');
  return module.append(kExtension);
}

/// Lua reports an unknown global of a script that is loaded without its column, and the check of the text reports it
/// with its column and a suggestion. `all`: in order.
void drop_findings_without_column(std::vector<Finding>& all) {
  const auto is_repeated = [&](const Finding& finding) {
    return finding.position.column == 0 && finding.position.line > 0 &&
           std::any_of(all.begin(), all.end(), [&](const Finding& other) {
             return other.position.column > 0 && other.file == finding.file &&
                    other.position.line == finding.position.line && other.severity == finding.severity &&
                    other.message.starts_with(finding.message);
           });
  };
  std::vector<Finding> kept;
  std::copy_if(all.begin(), all.end(), std::back_inserter(kept), std::not_fn(is_repeated));
  all = std::move(kept);
}

class ScriptCheck {
 public:
  explicit ScriptCheck(TextsToCheck texts)
      : texts_(std::move(texts.scripts)), tests_(std::move(texts.tests)), application_(merged(texts.interfaces)) {
    declared_.interfaces = std::move(texts.interfaces);
    declare(core_, core_parameters_);
  }

  CheckResult run() {
    load_together(texts_.in_folder("behaviors"));
    for (const std::string& scenario : texts_.in_folder("scenarios")) load_with_behaviors(scenario);
    declared_.behavior_scripts = names_of_scripts("behaviors");
    declared_.scenario_scripts = names_of_scripts("scenarios");
    // Libraries come first because the other scripts call their functions.
    for (const std::string& file : texts_.in_folder("lib")) check_library(file);
    for (const std::string& file : texts_.in_folder("behaviors")) check_script_text(file, ScriptRole::behavior);
    for (const std::string& file : texts_.in_folder("scenarios")) check_script_text(file, ScriptRole::scenario);
    for (const auto& [file, text] : tests_) check_script_text(file, ScriptRole::test);
    std::vector<Finding>& all = result_.findings;
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return order(a) < order(b); });
    // A behavior that several scenarios load is reported once.
    all.erase(std::unique(all.begin(), all.end(), [](const auto& a, const auto& b) { return order(a) == order(b); }),
              all.end());
    drop_findings_without_column(all);
    return std::move(result_);
  }

 private:
  void note(const ScriptError& error) {
    for (const ScriptFault& fault : error.all)
      result_.findings.push_back({Severity::error, fault.file, {fault.line, fault.column}, fault.message});
  }

  /// Names under which they can be loaded: "paper/paper_orientation", "behaviors/paper/paper_orientation.lua".
  std::set<std::string> names_of_scripts(const std::string& folder) const {
    std::set<std::string> names;
    for (const std::string& file : texts_.in_folder(folder)) {
      names.insert(file);
      names.insert(file.substr(folder.size() + 1, file.size() - folder.size() - 1 - kExtension.size()));
    }
    return names;
  }

  void load(ScriptHost& host, const std::string& file) {
    try {
      host.load(file);
    } catch (const ScriptError& error) {
      note(error);
      take_in_text(file);
      for (const std::string& library : texts_.in_folder("lib")) take_in_text(library);
    }
  }

  /// The names that a script declares which cannot be loaded, so that its mistake hides no other one. The states of its
  /// machine stay unknown.
  void take_in_text(const std::string& file) {
    const ScriptText* const script = texts_.find(file);
    if (script == nullptr || !taken_in_texts_.insert(file).second) return;
    const std::string stem = std::filesystem::path(file).stem().string();
    const std::vector<LuaToken> tokens = lua_tokens(script->text);
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
      if (tokens[i].kind != LuaToken::Kind::name) continue;
      const std::string& word = tokens[i].text;
      const bool is_assigned = tokens[i + 1].is_symbol("=");
      const LuaToken& value = tokens[is_assigned ? i + 2 : i + 1];
      if (is_assigned) declared_.parameters.insert(std::string(stem).append(".").append(word));
      if (value.kind != LuaToken::Kind::text) continue;
      if (is_assigned && word == "publishes") declared_.published.insert(value.text);
      if (!is_assigned && word == "behavior") declared_.behaviors[value.text];
      if (!is_assigned && word == "scenario") declared_.scenarios[value.text];
    }
  }

  void load_together(const std::vector<std::string>& behaviors) {
    BehaviorLanguage language(application_);
    ScriptHost host(texts_, language, core_parameters_);
    for (const std::string& file : behaviors) load(host, file);
    take_in(host);
    take_in(core_parameters_);
  }

  void load_with_behaviors(const std::string& scenario) {
    ScenarioLanguage scenario_language;
    ParameterRegistry parameters;
    ScriptHost host(texts_, scenario_language, parameters);
    load(host, scenario);
    take_in(host);
    take_in(parameters);
    BehaviorLanguage behavior_language(application_);
    ScriptHost behaviors(texts_, behavior_language, core_parameters_);
    for (const MachineDefinition* machine : host.definitions()) {
      for (const std::string& behavior : machine->behaviors) {
        const std::string file = script_file(behavior_language.folder(), behavior);
        load(behaviors, file);
        check_interface(*machine, file);
      }
    }
    take_in(behaviors);
  }

  /// Warns of a scenario whose interface lacks what its behavior uses. `--interface` may set another one.
  void check_interface(const MachineDefinition& scenario, const std::string& behavior) {
    const ScriptText* const script = texts_.find(behavior);
    if (script == nullptr) return;
    const std::string name = std::filesystem::path(scenario.setting.interface).stem().string();
    const std::vector<ApplicationInterface>& known = declared_.interfaces;
    const auto own = std::find_if(known.begin(), known.end(), [&](const auto& one) { return one.name == name; });
    if (!name.empty() && own == known.end()) return;  // the run reports it
    const std::vector<MissingValue> missing =
        missing_values(script->text, own == known.end() ? ApplicationInterface() : *own, known);
    if (missing.empty()) return;
    result_.findings.push_back(
        {Severity::warning, scenario.file, scenario.position,
         "in " + behavior + ", " + to_text(missing) + ": interface = \"" + missing.front().interfaces.front() + "\""});
  }

  void take_in(const ScriptHost& host) {
    for (const MachineDefinition* machine : host.definitions()) {
      const bool is_called = !machine->caller.empty();  // its file is checked by itself
      for (DeclarationError& warning : is_called ? std::vector<DeclarationError>() : machine_warnings(*machine))
        result_.findings.push_back({Severity::warning, warning.file, warning.position, std::move(warning.message)});
      auto& machines = machine->is_scenario ? declared_.scenarios : declared_.behaviors;
      for (const StateDefinition& state : machine->states) {
        machines[machine->name].insert(state.path);
        if (!state.publishes.empty()) declared_.published.insert(state.publishes);
      }
    }
    for (auto& [module, fields] : host.module_fields()) {
      auto table = std::make_shared<TableSymbol>(TableSymbol{module, module + " has no field '", {}, false});
      for (const std::string& field : fields) table->fields[field];
      modules_[module] = std::move(table);
    }
  }

  void take_in(const ParameterRegistry& parameters) {
    for (const Parameter& parameter : parameters.list()) declared_.parameters.insert(parameter.name);
  }

  /// Checks the libraries that it requires first.
  void check_library(const std::string& file) {
    const ScriptText* const text = texts_.find(file);
    if (text == nullptr || !checked_libraries_.insert(file).second) return;
    for (const LuaToken& token : lua_tokens(text->text)) {
      if (token.kind == LuaToken::Kind::text && modules_.contains(token.text)) check_library(file_of(token.text));
    }
    check_script_text(file, ScriptRole::library);
  }

  void check_script_text(const std::string& file, ScriptRole role) {
    ++result_.files;
    const ScriptText script = text_of(file, role);
    if (!script.problem.empty()) {
      // The loader has already reported the scripts that it tried to read.
      const bool is_loaded_before = role == ScriptRole::behavior || role == ScriptRole::scenario;
      if (!is_loaded_before) result_.findings.push_back({Severity::error, file, {}, script.problem});
      return;
    }
    const std::string& text = script.text;
    Sandbox sandbox{ScriptLimits{}};
    if (std::optional<ScriptFault> fault = sandbox.compile(text, file)) {
      // Same wording as the loader's, so that an error that the loader also found is listed once.
      const int column = SourceLocations(text).column_of_syntax_error(fault->message, fault->line);
      result_.findings.push_back({Severity::error, file, {fault->line, column}, fault->message});
      return;
    }
    SymbolTable known = symbol_table(role, declared_);
    for (const auto& [module, table] : modules_) {
      known.modules[module] = {kTable, table};
      const ScriptText* const library = texts_.find(file_of(module));
      known.modules_use_metatables |= library != nullptr && library->text.find("setmetatable") != std::string::npos;
    }
    TextCheck check = check_text(text, known);
    for (Finding& finding : check.findings) {
      finding.file = file;
      result_.findings.push_back(std::move(finding));
    }
    if (role == ScriptRole::library) take_in(module_name(file), check.functions);
  }

  /// Types of a library's functions, from its text.
  void take_in(const std::string& module, const std::map<std::string, FunctionSymbol>& functions) {
    const auto found = modules_.find(module);
    if (found == modules_.end()) return;
    for (const auto& [name, function] : functions) {
      const auto field = found->second->fields.find(name);
      if (field == found->second->fields.end()) continue;
      field->second = {kFunction, nullptr, std::make_shared<const FunctionSymbol>(function)};
    }
  }

  ScriptText text_of(const std::string& file, ScriptRole role) const {
    if (role == ScriptRole::test) return tests_.at(file);
    const ScriptText* const text = texts_.find(file);
    return text != nullptr ? *text : ScriptText{"", "expected a script, found none"};
  }

  ScriptTexts texts_;
  std::map<std::string, ScriptText> tests_;
  CoreParameters core_;
  ParameterRegistry core_parameters_;  ///< the engine's, whose names scripts must not use
  ApplicationState application_;
  DeclaredNames declared_;
  std::map<std::string, std::shared_ptr<TableSymbol>> modules_;
  std::set<std::string> checked_libraries_, taken_in_texts_;
  CheckResult result_;
};

/// The path relative to the root. Throws if it is not below the root.
std::string below(const std::filesystem::path& root, const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw std::runtime_error(path.string() + ": expected a file or folder, found none");
  if (!std::filesystem::is_directory(path, error) && path.extension() != kExtension)
    throw std::runtime_error(path.string() + ": expected a folder or a file *" + std::string(kExtension) +
                             ", found another file");
  const std::optional<std::string> relative = path_below(root, path);
  if (!relative)
    throw std::runtime_error(path.string() + ": expected a path below " + root.string() +
                             " (set the scripts' root with --scripts)");
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

std::vector<std::string> scripted_tests(const std::filesystem::path& scripts_root) {
  std::vector<std::string> files;
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator entry(scripts_root / "tests", error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().filename().string().ends_with("_test.lua"))
      files.push_back(entry->path().lexically_relative(scripts_root).generic_string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

CheckResult check_texts(TextsToCheck texts) { return ScriptCheck(std::move(texts)).run(); }

CheckResult check_scripts(const std::filesystem::path& scripts_root, std::span<const std::filesystem::path> paths) {
  std::vector<std::string> requested;
  for (const std::filesystem::path& path : paths) requested.push_back(below(scripts_root, path));
  CheckResult result = check_texts(read_texts_to_check(scripts_root));
  if (requested.empty()) return result;
  std::erase_if(result.findings, [&](const Finding& finding) {
    return std::none_of(requested.begin(), requested.end(), [&](const std::string& path) {
      return path == "." || finding.file == path || finding.file.starts_with(path + "/");
    });
  });
  return result;
}

}  // namespace reorient

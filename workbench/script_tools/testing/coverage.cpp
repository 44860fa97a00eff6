#include "workbench/script_tools/testing/coverage.h"

#include <initializer_list>
#include <ostream>

#include "engine/script/language/behavior_language.h"
#include "engine/script/script_host.h"
#include "workbench/files/script_files.h"
#include "workbench/scenario/scenario_language.h"

namespace reorient {
namespace {

std::string place(const MachineDefinition& machine, TextPosition position) {
  return place_text(machine.file, position.line, position.column);
}

/// The machine as a whole is no state that one would count.
bool is_counted(const StateDefinition& state) { return !state.path.empty(); }

void report(const MachineDefinition& machine, const CoverageTrace& trace, std::ostream& out) {
  std::string left_out;
  int states = 0, entered = 0;
  for (const StateDefinition& state : machine.states) {
    if (!is_counted(state)) continue;
    ++states;
    if (trace.entered(machine.name, state.path)) {
      ++entered;
    } else {
      left_out += "  " + place(machine, state.position) + ": never entered: " + state.path + "\n";
    }
  }
  int taken = 0;
  for (const TransitionDefinition& transition : machine.transitions) {
    if (trace.took(machine.name, transition.key)) {
      ++taken;
      continue;
    }
    const std::string& from = machine.states[transition.from].path;
    left_out += "  " + place(machine, transition.position) + ": never taken: " + (from.empty() ? "any state" : from) +
                " > " + machine.states[transition.to].path + " (" + transition.because + ")\n";
  }
  out << machine.name << ": " << entered << " of " << states << " states, " << taken << " of "
      << machine.transitions.size() << " transitions\n"
      << left_out;
}

}  // namespace

void CoverageTrace::note(std::span<const MachineDefinition* const> machines, const NameTable& names,
                         std::span<const TransitionRecord> transitions) {
  for (const TransitionRecord& record : transitions) {
    for (std::string path = names[record.to]; !path.empty();) {
      states_.insert({names[record.machine], path});
      const std::size_t slash = path.rfind('/');
      path.resize(slash == std::string::npos ? 0 : slash);
    }
    for (const MachineDefinition* machine : machines) {
      const auto index = static_cast<std::size_t>(record.transition);
      const bool is_its_own = machine->name_id == record.machine && record.transition >= 0;
      if (is_its_own && index < machine->transitions.size())
        transitions_.insert({machine->name, machine->transitions[index].key});
    }
  }
}

void report_coverage(const CoverageTrace& trace, const std::filesystem::path& scripts_root, std::ostream& out) {
  const ScriptTexts texts = read_scripts(scripts_root);
  BehaviorLanguage behavior_language;
  ScenarioLanguage scenario_language;
  for (ScriptLanguage* language : std::initializer_list<ScriptLanguage*>{&behavior_language, &scenario_language}) {
    for (const std::string& file : texts.in_folder(language->folder())) {
      ParameterRegistry parameters;
      ScriptHost host(texts, *language, parameters);
      host.load(file);
      for (const MachineDefinition* machine : host.definitions()) report(*machine, trace, out);
    }
  }
}

}  // namespace reorient

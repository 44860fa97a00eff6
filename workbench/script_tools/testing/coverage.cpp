#include "workbench/script_tools/testing/coverage.h"

#include <ostream>

#include "engine/script/script_error.h"

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
    left_out += "  " + place(machine, transition.position) + ": never taken: " + (from.empty() ? "always" : from) +
                " > " + machine.states[transition.to].path + " (" + transition.because + ")\n";
  }
  out << machine.name << ": " << entered << " of " << states << " states, " << taken << " of "
      << machine.transitions.size() << " transitions\n"
      << left_out;
}

}  // namespace

void CoverageTrace::note(const ScriptHost& host, const ScriptOutput& output) {
  if (output.transitions.empty()) return;
  const std::vector<const MachineDefinition*> definitions = host.definitions();
  for (const TransitionRecord& record : output.transitions) {
    for (std::string path = record.to; !path.empty();) {
      states_.insert({record.machine, path});
      const std::size_t slash = path.rfind('/');
      path.resize(slash == std::string::npos ? 0 : slash);
    }
    for (const MachineDefinition* machine : definitions) {
      const auto index = static_cast<std::size_t>(record.transition);
      const bool is_its_own = machine->name == record.machine && record.transition >= 0;
      if (is_its_own && index < machine->transitions.size())
        transitions_.insert({machine->name, machine->transitions[index].key});
    }
  }
}

void report_coverage(const CoverageTrace& trace, const std::filesystem::path& scripts_root, std::ostream& out) {
  ParameterRegistry parameters;
  for (const char* folder : {"behaviors", "scenarios"}) {
    for (const std::string& file : scripts_in(scripts_root, folder)) {
      ScriptHost host(scripts_root, parameters);
      const std::string full = (scripts_root / file).string();
      folder == std::string("behaviors") ? host.load_behavior(full) : host.load_scenario(full);
      for (const MachineDefinition* machine : host.definitions()) {
        if (machine->file == file) report(*machine, trace, out);
      }
    }
  }
}

}  // namespace reorient

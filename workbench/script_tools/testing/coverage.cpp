// SPDX-License-Identifier: MIT
#include "workbench/script_tools/testing/coverage.h"

#include <algorithm>
#include <initializer_list>
#include <ostream>

#include "engine/parameters/counted.h"
#include "engine/parameters/utf8.h"
#include "engine/script/language/behavior_language.h"
#include "engine/script/script_error.h"
#include "engine/script/script_host.h"
#include "workbench/files/interface_file.h"
#include "workbench/files/script_files.h"
#include "workbench/scenario/scenario_language.h"

namespace reorient {
namespace {

/// The number of states or transitions, and how many of them the tests covered.
struct Share {
  int taken = 0;
  int all = 0;

  void count(bool is_taken) {
    ++all;
    taken += is_taken ? 1 : 0;
  }
  void add(Share other) {
    taken += other.taken;
    all += other.all;
  }
};

std::string text(Share share) { return std::to_string(share.taken) + " of " + std::to_string(share.all); }

/// Rounded down: 100 % means all.
std::string percent(Share share) {
  return share.all == 0 ? "" : " (" + std::to_string(100 * share.taken / share.all) + " %)";
}

struct Shares {
  Share states;
  Share transitions;

  void add(const Shares& other) {
    states.add(other.states);
    transitions.add(other.transitions);
  }
};

std::string text(const Shares& shares) {
  return text(shares.states) + " states, " + text(shares.transitions) + " transitions";
}

std::string with_percents(const Shares& shares) {
  return text(shares.states) + " states" + percent(shares.states) + ", " + text(shares.transitions) + " transitions" +
         percent(shares.transitions);
}

/// Coverage of one machine.
struct MachineCoverage {
  Shares own;                             ///< in the script's own file
  std::map<std::string, Shares> by_file;  ///< added to it by other files
  std::string left_out;                   ///< not covered in the script's own file, one line each

  Shares& of(const std::string& file, const std::string& script) { return file == script ? own : by_file[file]; }
};

std::string place(const StateDefinition& state, TextPosition position) {
  return "  " + place_text(state.file, position.line, position.column);
}

/// `script`: the file that was loaded for it. `trace`: nullptr if no test ran it.
MachineCoverage coverage_of(const MachineDefinition& machine, const std::string& script, const MachineTrace* trace) {
  MachineCoverage found;
  for (const StateDefinition& state : machine.states) {
    if (state.path.empty()) continue;  // the machine as a whole is not counted as a state
    const bool is_entered = trace != nullptr && trace->states.contains(state.path);
    found.of(state.file, script).states.count(is_entered);
    if (!is_entered && state.file == script)
      found.left_out += as_line(place(state, state.position) + ": never entered: " + state.path) + "\n";
  }
  for (const TransitionDefinition& transition : machine.transitions) {
    const StateDefinition& from = machine.states[transition.from];
    const std::string& maker = transition.maker.empty() ? from.file : transition.maker;
    const bool is_taken = trace != nullptr && trace->transitions.contains(transition.key);
    found.of(maker, script).transitions.count(is_taken);
    if (!is_taken && maker == script)
      found.left_out +=
          as_line(place(from, transition.position) + ": never taken: " + (from.path.empty() ? "any state" : from.path) +
                  " > " + machine.states[transition.to].path + " (" + transition.because + ")") +
          "\n";
  }
  return found;
}

class CoverageReport {
 public:
  CoverageReport(const CoverageTrace& trace, std::ostream& out) : trace_(trace), out_(out) {}

  void add(const MachineDefinition& machine, const std::string& script) {
    const MachineTrace* const trace = trace_.find(machine);
    const MachineCoverage found = coverage_of(machine, script, trace);
    ++count_;
    all_.add(found.own);
    if (trace == nullptr) {
      not_run_ += as_line(machine.name) + ": no test loaded it\n";
      return;
    }
    ++run_count_;
    run_.add(found.own);
    out_ << as_line(machine.name) << ": " << text(found.own) << "\n" << found.left_out;
    for (const auto& [file, shares] : found.by_file) {
      out_ << "  from " << as_line(file) << ": " << text(shares) << "\n";
      from_libraries_.add(shares);
    }
  }

  void finish() {
    out_ << not_run_ << "total: ";
    if (run_count_ == 0) {
      out_ << with_percents(all_) << ": no test loaded a machine\n";
      return;
    }
    out_ << with_percents(run_) << " of the " << counted(run_count_, "machine") << " that tests loaded";
    if (from_libraries_.states.all + from_libraries_.transitions.all > 0)
      out_ << "; from libraries: " << with_percents(from_libraries_);
    if (count_ > run_count_) out_ << "; " << with_percents(all_) << " of all " << counted(count_, "machine");
    out_ << "\n";
  }

 private:
  const CoverageTrace& trace_;
  std::ostream& out_;
  std::string not_run_;
  int count_ = 0;
  int run_count_ = 0;
  Shares all_;
  Shares run_;             ///< of the machines that tests ran
  Shares from_libraries_;  ///< in these, by other files
};

}  // namespace

void CoverageTrace::note(std::span<const MachineDefinition* const> machines, const NameTable& names,
                         std::span<const TransitionRecord> transitions) {
  for (const TransitionRecord& record : transitions) {
    const auto found = std::find_if(machines.begin(), machines.end(), [&](const MachineDefinition* machine) {
      return machine->name_id == record.machine;
    });
    if (found == machines.end()) continue;
    const MachineDefinition& machine = **found;
    // A behavior that another one runs counts for its own script.
    MachineTrace& trace = machines_[{machine.file, std::string(machine.behavior())}];
    for (std::string path = names[record.to]; !path.empty();) {
      trace.states.insert(path);
      const std::size_t slash = path.rfind('/');
      path.resize(slash == std::string::npos ? 0 : slash);
    }
    const auto index = static_cast<std::size_t>(record.transition);
    if (record.transition >= 0 && index < machine.transitions.size())
      trace.transitions.insert(machine.transitions[index].key);
  }
}

const MachineTrace* CoverageTrace::find(const MachineDefinition& machine) const {
  const auto found = machines_.find({machine.file, machine.name});
  return found == machines_.end() ? nullptr : &found->second;
}

std::vector<std::string> report_coverage(const CoverageTrace& trace, const std::filesystem::path& scripts_root,
                                         std::ostream& out) {
  const ScriptTexts texts = read_scripts(scripts_root);
  const ApplicationState application(merged(known_interfaces(scripts_root)));
  BehaviorLanguage behavior_language(application);
  ScenarioLanguage scenario_language;
  CoverageReport report(trace, out);
  std::vector<std::string> failures;
  for (ScriptLanguage* language : std::initializer_list<ScriptLanguage*>{&behavior_language, &scenario_language}) {
    for (const std::string& file : texts.in_folder(language->folder())) {
      ParameterRegistry parameters;
      ScriptHost host(texts, *language, parameters);
      try {
        host.load(file);
      } catch (const ScriptError& error) {
        failures.push_back(file + " is not in the coverage: " + error.what());
        continue;
      }
      for (const MachineDefinition* machine : host.definitions()) {
        if (machine->caller.empty()) report.add(*machine, file);
      }
    }
  }
  report.finish();
  return failures;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
// States and transitions of the scripts that the tests covered.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/script/machine/machine_definition.h"
#include "engine/script/script_output.h"

namespace reorient {

/// States and transitions that one machine went through.
struct MachineTrace {
  std::set<std::string> states;       ///< entered: paths
  std::set<std::string> transitions;  ///< taken: keys
};

/// Entered states and taken transitions by machine; filled while tests run.
class CoverageTrace {
 public:
  /// After each frame.
  void note(std::span<const MachineDefinition* const> machines, const NameTable& names,
            std::span<const TransitionRecord> transitions);

  /// Returns nullptr if no test ran it.
  const MachineTrace* find(const MachineDefinition& machine) const;

 private:
  std::map<std::pair<std::string, std::string>, MachineTrace> machines_;  ///< by file and name
};

/// Writes the coverage of all behaviors and scenarios below the root. For each machine that the tests ran: the
/// fraction, then each state of its file that was never entered and each transition that was never taken, with file,
/// line and column, and the fraction of the states and transitions that libraries add. Then one line for each machine
/// that the tests did not run, and the total. Returns one line about each script that cannot be loaded; it is not
/// counted. Throws std::runtime_error if there are no scripts.
std::vector<std::string> report_coverage(const CoverageTrace& trace, const std::filesystem::path& scripts_root,
                                         std::ostream& out);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Which states and transitions of the scripts the tests covered.
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

/// What happened in one machine.
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

  /// nullptr: no test ran it.
  const MachineTrace* find(const MachineDefinition& machine) const;

 private:
  std::map<std::pair<std::string, std::string>, MachineTrace> machines_;  ///< by file and name
};

/// What of all behaviors and scenarios below the root the tests took. Of each machine that they ran: the share, then
/// each state of its file that was never entered and each transition that was never taken, with file, line and column,
/// and the share of what a library makes in it. Then one line for each machine that they did not run, and one for all.
/// Returns one line about each script that cannot be loaded, which is left out. Throws std::runtime_error where there
/// are no scripts.
std::vector<std::string> report_coverage(const CoverageTrace& trace, const std::filesystem::path& scripts_root,
                                         std::ostream& out);

}  // namespace reorient

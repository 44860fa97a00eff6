// Which states and transitions of the scripts the tests took, and which they left out.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "engine/script/machine/machine_definition.h"
#include "engine/script/script_output.h"

namespace reorient {

/// What was seen to happen, by machine; filled while tests run.
class CoverageTrace {
 public:
  /// After each frame.
  void note(std::span<const MachineDefinition* const> machines, const NameTable& names,
            std::span<const TransitionRecord> transitions);

  bool entered(const std::string& machine, const std::string& path) const { return states_.contains({machine, path}); }
  bool took(const std::string& machine, const std::string& key) const { return transitions_.contains({machine, key}); }

 private:
  std::set<std::pair<std::string, std::string>> states_;       ///< machine, path
  std::set<std::pair<std::string, std::string>> transitions_;  ///< machine, key
};

/// One line a machine, and below it each state that was never entered and each transition that was never taken, with
/// file, line and column. All behaviours and scenarios below the root are counted, also those that no test loads.
/// Throws ScriptError when one cannot be loaded.
void report_coverage(const CoverageTrace& trace, const std::filesystem::path& scripts_root, std::ostream& out);

}  // namespace reorient

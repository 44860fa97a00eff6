// SPDX-License-Identifier: MIT
// Where a machine looks at other machines, as far as that is plain from its script's text.
#pragma once

#include <map>
#include <set>
#include <string>
#include <tuple>

#include "engine/script/machine/machine_definition.h"
#include "engine/script/script_texts.h"

namespace reorient {

/// `published.FLAG`, or `behaviors.MACHINE.FIELD`.
struct Sight {
  std::string machine;  ///< empty: whichever publishes the flag
  std::string field;    ///< "state" or "time_in_state", or the flag
  std::string state;    ///< path that the field is compared with; empty: it is not compared with a text

  bool operator==(const Sight&) const = default;
  bool operator<(const Sight& other) const {
    return std::tie(machine, field, state) < std::tie(other.machine, other.field, other.state);
  }
};

/// By the state in whose table it is written, the innermost one; 0: in that of the machine itself. A local function
/// counts where it is named, and so does one of a library. Names that are put together at run time are not found.
std::map<int, std::set<Sight>> sights_of(const MachineDefinition& machine, const ScriptTexts& texts);

}  // namespace reorient

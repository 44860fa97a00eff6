// SPDX-License-Identifier: MIT
// Where a machine reads the states of other machines, as far as its script's text shows it.
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
  std::string machine;  ///< empty: the machine that publishes the flag
  std::string field;    ///< "state" or "time_in_state", or the flag
  std::string state;    ///< path that the field is compared with; empty: it is not compared with a text

  bool operator==(const Sight&) const = default;
  bool operator<(const Sight& other) const {
    return std::tie(machine, field, state) < std::tie(other.machine, other.field, other.state);
  }
};

/// By the index of the innermost state whose table contains the code; 0: the table of the machine itself. A function of
/// the script or of a library counts where it is referred to. Names that are built at run time are not found.
std::map<int, std::set<Sight>> sights_of(const MachineDefinition& machine, const ScriptTexts& texts);

}  // namespace reorient

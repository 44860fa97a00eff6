// SPDX-License-Identifier: MIT
// The values and actions of an application as named scalars, for lists, tables and viewers.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "engine/record/frame_record.h"

namespace reorient {

struct NamedScalar {
  std::string name;  ///< "input.ball.position.x", "input.age.ball.position", "action.kick.state"
  std::variant<double, bool, std::string> value;
  std::string unit;         ///< of a number, or empty
  std::string description;  ///< one phrase, or empty
};

/// All of them, in the order of the declarations: the content of each value, its age and whether it is valid, and the
/// state of each action. A list is one text. The same names for each frame of a run. `time`: s.
std::vector<NamedScalar> application_values(const ApplicationRecord& application, double time);

/// The same before the first frame, with defaults.
std::vector<NamedScalar> application_values(const ApplicationInterface& declared);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// The scripts in new/, which `reorient new` starts a script from.
#pragma once

#include <string>

namespace reorient {

/// Of "behavior", "behavior_test", "scenario" and "scenario_test"; NAME stands in it for the name of the new script.
std::string script_template(const std::string& kind);

}  // namespace reorient

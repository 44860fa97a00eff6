// SPDX-License-Identifier: MIT
// The templates in new/ for the scripts of `reorient new`.
#pragma once

#include <string>

namespace reorient {

/// The template "behavior", "behavior_test", "scenario" or "scenario_test"; NAME is the placeholder of the script's
/// name.
std::string script_template(const std::string& kind);

}  // namespace reorient

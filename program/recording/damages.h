// SPDX-License-Identifier: MIT
// Reports the damaged parts of a recording, and what is missing.
#pragma once

#include <iosfwd>
#include <string>

#include "workbench/recording/recording.h"

namespace reorient {

/// Prints one line for each damage.
void tell_damages(const Recording& recording, std::ostream& err);

/// "3 frames lost; 5 frames without their images"; empty: nothing is missing.
std::string text_of(const Recording::Losses& losses);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Reports the damaged parts of a recording.
#pragma once

#include <iosfwd>

#include "workbench/recording/recording.h"

namespace reorient {

/// Prints one line for each damage.
void tell_damages(const Recording& recording, std::ostream& err);

}  // namespace reorient

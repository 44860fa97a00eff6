// SPDX-License-Identifier: MIT
// Reports the damaged parts of a recording.
#pragma once

#include <iosfwd>

#include "workbench/recording/recording.h"

namespace reorient {

/// A line each.
void tell_damages(const Recording& recording, std::ostream& err);

}  // namespace reorient

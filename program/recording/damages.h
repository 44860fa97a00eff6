// SPDX-License-Identifier: MIT
// What of a recording was left out, said to whoever reads it.
#pragma once

#include <iosfwd>

#include "workbench/recording/recording.h"

namespace reorient {

/// A line each.
void tell_damages(const Recording& recording, std::ostream& err);

}  // namespace reorient

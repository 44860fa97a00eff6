// SPDX-License-Identifier: MIT
// A pose on the field, as on the command line.
#pragma once

#include <optional>
#include <string>

#include "geometry/pose2.h"

namespace reorient {

/// Of --at: X,Y,DEGREES in the field's frame; nothing if the text is empty. Throws std::runtime_error with one line.
std::optional<Pose2> place_of(const std::string& text);

}  // namespace reorient

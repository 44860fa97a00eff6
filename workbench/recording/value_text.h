// SPDX-License-Identifier: MIT
// Numbers and values of the world in words.
#pragma once

#include <string>

#include "engine/script/language/world_fields.h"

namespace reorient {

/// As short as it can be without being another number.
std::string exact_text(double number);

/// "true", "upright", "0.25".
std::string exact_text(const WorldField& field, double value);

}  // namespace reorient

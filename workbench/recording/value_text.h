// SPDX-License-Identifier: MIT
// Numbers and world fields as text.
#pragma once

#include <string>

#include "engine/script/language/world_fields.h"
#include "workbench/run/application_values.h"

namespace reorient {

/// The shortest text that represents exactly this number.
std::string exact_text(double number);

/// "true", "striker", "0.25".
std::string exact_text(const NamedScalar& scalar);

/// "true", "upright", "0.25".
std::string exact_text(const WorldField& field, double value);

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Declarations of an application for tests.
#pragma once

#include <string>
#include <utility>

#include "robots/application.h"

namespace reorient {

inline DeclaredField declared_field(const std::string& name, FieldType type, FieldData initial) {
  DeclaredField field;
  field.name = name;
  field.type = type;
  field.initial = std::move(initial);
  return field;
}

}  // namespace reorient

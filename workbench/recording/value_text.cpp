// SPDX-License-Identifier: MIT
#include "workbench/recording/value_text.h"

#include "engine/parameters/parameter.h"

namespace reorient {

std::string exact_text(double number) { return to_text(ParameterValue(number)); }

std::string exact_text(const NamedScalar& scalar) {
  if (const bool* const yes = std::get_if<bool>(&scalar.value)) return *yes ? "true" : "false";
  if (const double* const number = std::get_if<double>(&scalar.value)) return exact_text(*number);
  return std::get<std::string>(scalar.value);
}

std::string exact_text(const WorldField& field, double value) {
  if (field.type == WorldField::Type::boolean) return value != 0.0 ? "true" : "false";
  const auto index = static_cast<std::size_t>(value);
  if (field.type == WorldField::Type::name && index < field.names.size()) return std::string(field.names[index]);
  return exact_text(value);
}

}  // namespace reorient

#include "workbench/recording/value_text.h"

#include <array>
#include <charconv>

namespace reorient {

std::string number_text(double number) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), end};
}

std::string value_text(const WorldField& field, double value) {
  if (field.type == WorldField::Type::boolean) return value != 0.0 ? "true" : "false";
  const auto index = static_cast<std::size_t>(value);
  if (field.type == WorldField::Type::name && index < field.names.size()) return std::string(field.names[index]);
  return number_text(value);
}

}  // namespace reorient

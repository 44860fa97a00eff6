// SPDX-License-Identifier: MIT
#include "workbench/script_tools/check/value_types.h"

#include <utility>

namespace reorient {

std::string in_words(ValueTypes types) {
  constexpr std::pair<ValueTypes, const char*> kNames[] = {
      {kNumber, "number"}, {kString, "string"}, {kBoolean, "boolean"}, {kTable, "table"}, {kFunction, "function"}};
  std::string text;
  for (const auto& [type, name] : kNames) {
    if ((types & type) != 0) text.append(text.empty() ? "" : " or ").append(name);
  }
  return text.empty() ? "nil" : text;
}

std::string with_article(ValueTypes types) {
  const std::string words = in_words(types);
  return words == "nil" ? words : "a " + words;
}

}  // namespace reorient

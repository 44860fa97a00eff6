// SPDX-License-Identifier: MIT
// A count with its noun, for messages: "1 flip", "2 flips".
#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace reorient {

/// `noun`: in the singular; its plural ends with "s", unless `plural` is given.
template <std::integral Count>
std::string counted(Count count, std::string_view noun, std::string_view plural = {}) {
  std::string text = std::to_string(count) + ' ';
  if (count == 1) return text.append(noun);
  return plural.empty() ? text.append(noun) + 's' : text.append(plural);
}

}  // namespace reorient

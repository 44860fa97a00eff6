// SPDX-License-Identifier: MIT
// Errors of the decoders: one line with the byte offset, the value, what was expected and what was found.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "robots/footage/footage.h"

namespace reorient::messages {

[[noreturn]] inline void fail_at(std::size_t byte, const std::string& problem) {
  throw BadFootage("byte " + std::to_string(byte) + ": " + problem);
}

/// Makes `text` of a file printable in one line of an error message: replaces control characters and bytes beyond ASCII
/// by '?' and truncates long text.
inline std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 200;
  std::string line;
  for (const char letter : text.substr(0, kLongest)) line += letter >= ' ' && letter < 0x7F ? letter : '?';
  if (text.size() > kLongest) line += "...";
  return line;
}

/// The matrix from a message's field `name`; zeros if the field is missing.
template <std::size_t Size>
std::array<double, Size> matrix_of(const std::vector<double>& numbers, const std::string& name) {
  std::array<double, Size> matrix{};
  if (!numbers.empty() && numbers.size() != Size) {
    throw BadFootage(name + ": expected " + std::to_string(Size) + " numbers, found " + std::to_string(numbers.size()));
  }
  std::copy(numbers.begin(), numbers.end(), matrix.begin());
  return matrix;
}

inline std::string in_quotes(std::string_view text) { return "'" + printable(text) + "'"; }

}  // namespace reorient::messages

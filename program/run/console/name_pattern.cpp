// SPDX-License-Identifier: MIT
#include "program/run/console/name_pattern.h"

#include <algorithm>
#include <stdexcept>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"

namespace reorient {

bool matches(std::string_view pattern, std::string_view name) {
  // If the rest of the pattern does not match, the last star consumes one more letter.
  std::size_t p = 0, n = 0, star = std::string_view::npos, taken = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken = n;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p;
      ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++taken;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::vector<std::size_t> pick(std::string_view wanted, std::span<const std::string> names, std::string_view kind) {
  const auto exact = std::find(names.begin(), names.end(), wanted);
  if (exact != names.end()) return {static_cast<std::size_t>(exact - names.begin())};
  const bool is_pattern = wanted.find('*') != std::string_view::npos;
  std::vector<std::size_t> picked;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (is_pattern ? matches(wanted, names[i]) : names[i].find(wanted) != std::string::npos) picked.push_back(i);
  }
  if (picked.empty())
    throw std::runtime_error("unknown " + std::string(kind) + " '" + std::string(wanted) + "'" +
                             did_you_mean(wanted, names));
  return picked;
}

std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 300;
  std::string out = as_line(text);
  if (out.size() <= kLongest) return out;
  std::size_t end = kLongest;
  while ((static_cast<unsigned char>(out[end]) & 0xC0U) == 0x80U) --end;  // not within a letter
  return out.substr(0, end) + " ...";
}

}  // namespace reorient

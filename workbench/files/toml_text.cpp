// SPDX-License-Identifier: MIT
#include "workbench/files/toml_text.h"

#include <algorithm>
#include <fstream>
#include <utility>

#include <toml++/toml.h>

namespace reorient {
namespace {

constexpr std::size_t kLargest = 1024 * 1024;  // bytes
/// The parser calls itself once for each part of a dotted key. The length of a line limits their number, and so the
/// stack; the parser's own limit applies to brackets only.
constexpr std::size_t kLongestLine = 1000;  // bytes

TomlExcess excess_at(std::string_view text, std::size_t place, std::string why) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(place);
  return {1 + static_cast<int>(std::count(text.begin(), end, '\n')), std::move(why)};
}

std::optional<std::size_t> long_line(std::string_view text) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end - begin > kLongestLine) return begin;
    begin = end + 1;
  }
  return std::nullopt;
}

bool is_beyond_ascii(char letter) { return static_cast<unsigned char>(letter) > 0x7F; }

/// The end of the string whose opening quotes (one or three) are at `begin`; or the position of a letter beyond ASCII
/// that the parser would treat as a blank: after a backslash in a multi-line string.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const std::string three(3, quote);
  const bool has_lines = text.substr(begin).starts_with(three);
  for (std::size_t i = begin + (has_lines ? 3 : 1); i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      const std::size_t next = text.find_first_not_of(" \t\n\v\f\r", ++i);
      if (has_lines && next != std::string_view::npos && is_beyond_ascii(text[next])) return next;
    } else if (!has_lines && (text[i] == quote || text[i] == '\n')) {
      return i + 1;
    } else if (has_lines && text.substr(i).starts_with(three)) {
      // One or two more quotes are the last letters of the string.
      for (i += 3; i < text.size() && text[i] == quote;) ++i;
      return i;
    }
  }
  return text.size();
}

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // some editors write it

/// The first byte beyond ASCII outside of quotes and comments, or after a backslash. TOML hardly permits any, and the
/// parser's behavior is undefined for some (toml++ 3.3.0: U+00A1).
std::optional<std::size_t> letter_beyond_ascii(std::string_view text) {
  for (std::size_t i = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0; i < text.size();) {
    if (is_beyond_ascii(text[i])) return i;
    if (text[i] == '"' || text[i] == '\'') {
      i = end_of_string(text, i);
    } else if (text[i] == '#') {
      i = std::min(text.find('\n', i), text.size());
    } else {
      ++i;
    }
  }
  return std::nullopt;
}

/// If a text is not TOML, the parser may see quotes differently from letter_beyond_ascii(), and find such a letter
/// outside of them. Replaces these letters by question marks for the check.
std::optional<TomlExcess> mistake_beside_letters(std::string_view text) {
  std::string ascii(text);
  const std::ptrdiff_t begin = text.starts_with(kByteOrderMark) ? std::ssize(kByteOrderMark) : 0;
  std::replace_if(ascii.begin() + begin, ascii.end(), is_beyond_ascii, '?');
  if (ascii == text) return std::nullopt;
  try {
    static_cast<void>(toml::parse(ascii));
  } catch (const toml::parse_error& error) {
    return TomlExcess{static_cast<int>(error.source().begin.line), std::string(error.description())};
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> read_toml_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text(kLargest + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad() || !in.is_open()) return std::nullopt;
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

std::optional<TomlExcess> excess_in_toml(std::string_view text) {
  if (text.size() > kLargest) return excess_at(text, 0, "expected a file of at most 1 MiB, found a larger one");
  if (const std::optional<std::size_t> place = long_line(text))
    return excess_at(text, *place,
                     "expected a line of at most 1000 letters, found a longer one; break it into several");
  if (const std::optional<std::size_t> place = letter_beyond_ascii(text))
    return excess_at(text, *place,
                     "expected ASCII letters, found another one; put the name in quotes, and do not write such a "
                     "letter after a backslash");
  return mistake_beside_letters(text);
}

}  // namespace reorient

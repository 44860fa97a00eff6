// SPDX-License-Identifier: MIT
#include "workbench/files/toml_text.h"

#include <algorithm>
#include <utility>

#include <toml++/toml.h>

#include "engine/parameters/utf8.h"
#include "workbench/files/input_file.h"

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

/// The first byte beyond ASCII outside of quotes and comments, or after a backslash. TOML hardly permits any, and the
/// parser's behavior is undefined for some (toml++ 3.3.0: U+00A1).
std::optional<std::size_t> letter_beyond_ascii(std::string_view text) {
  for (std::size_t i = text.size() - without_byte_order_mark(text).size(); i < text.size();) {
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

constexpr std::string_view kHexDigits = "0123456789ABCDEF";

/// The text with its letters beyond ASCII, and the percent sign, as in a URL: different texts stay different. In TOML a
/// percent sign has no meaning.
std::string percent_encoded(std::string_view text) {
  std::string encoded;
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (is_beyond_ascii(letter) || letter == '%') {
      encoded.append(1, '%').append(1, kHexDigits[code / 16]).append(1, kHexDigits[code % 16]);
    } else {
      encoded += letter;
    }
  }
  return encoded;
}

std::string percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_code = text[i] == '%' && i + 2 < text.size();
    const std::size_t high = is_code ? kHexDigits.find(text[i + 1]) : std::string_view::npos;
    const std::size_t low = is_code ? kHexDigits.find(text[i + 2]) : std::string_view::npos;
    if (high == std::string_view::npos || low == std::string_view::npos) {
      decoded += text[i];
    } else {
      decoded += static_cast<char>(16 * high + low);
      i += 2;
    }
  }
  return decoded;
}

std::optional<toml::parse_error> mistake_in(std::string_view text) {
  try {
    static_cast<void>(toml::parse(text));
  } catch (const toml::parse_error& error) {
    return error;
  }
  return std::nullopt;
}

/// If a text is not TOML, the parser may see quotes differently from letter_beyond_ascii(), and find such a letter
/// outside of them. Replaces these letters for the check: by question marks, which keep the positions of all others,
/// and if that makes two names the same, by percent codes.
std::optional<TomlExcess> mistake_beside_letters(std::string_view text) {
  std::string ascii(text);
  const std::string_view content = without_byte_order_mark(text);
  std::replace_if(ascii.end() - std::ssize(content), ascii.end(), is_beyond_ascii, '?');
  if (ascii == text) return std::nullopt;
  std::optional<toml::parse_error> mistake = mistake_in(ascii);
  const bool may_be_two_names = mistake && mistake->description().find("redefine") != std::string_view::npos;
  if (may_be_two_names) mistake = mistake_in(percent_encoded(content));
  if (!mistake) return std::nullopt;
  const std::string why(mistake->description());
  return TomlExcess{static_cast<int>(mistake->source().begin.line), may_be_two_names ? percent_decoded(why) : why};
}

}  // namespace

std::string read_toml_text(const std::filesystem::path& file, const std::string& what) {
  return read_input(file, what, kLargest);
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

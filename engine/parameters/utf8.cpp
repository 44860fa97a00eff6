// SPDX-License-Identifier: MIT
#include "engine/parameters/utf8.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace reorient {
namespace {

/// Bytes of the text's first letter; 0 if it is invalid: truncated, overlong, a surrogate,
/// or outside Unicode.
std::size_t first_letter(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < size) return 0;
  std::uint32_t code = lead & (0xFFU >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
    code = code << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  return code < kLeast[size] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF) ? 0 : size;
}

/// Whether a terminal or a viewer may execute the letter instead of showing it.
bool is_control(std::string_view letter) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(letter[i]); };
  if (letter.size() == 1) return (byte(0) < ' ' && letter != "\n" && letter != "\t") || byte(0) == 0x7F;
  if (letter.size() == 2) return byte(0) == 0xC2 && byte(1) < 0xA0;  // U+0080 to U+009F
  if (letter.size() != 3 || byte(0) != 0xE2) return false;
  return (byte(1) == 0x80 && byte(2) >= 0xA8 && byte(2) <= 0xAE) ||  // U+2028 to U+202E
         (byte(1) == 0x81 && byte(2) >= 0xA6 && byte(2) <= 0xA9);    // U+2066 to U+2069
}

/// Escapes invalid bytes, and the letters for which `is_unwanted` holds.
std::string escaped(std::string_view text, bool (*is_unwanted)(std::string_view letter)) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t size = first_letter(text);
    const std::string_view letter = text.substr(0, std::max<std::size_t>(size, 1));
    if (size == 0 || is_unwanted(letter)) {
      out += written_out(letter);
    } else {
      out += letter;
    }
    text.remove_prefix(letter.size());
  }
  return out;
}

}  // namespace

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = first_letter(text);
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

std::string as_utf8(std::string_view text) {
  return escaped(text, [](std::string_view) { return false; });
}

std::string as_line(std::string_view text) {
  std::string out = escaped(text, is_control);
  std::replace_if(
      out.begin(), out.end(), [](char letter) { return letter == '\n' || letter == '\t'; }, ' ');
  while (out.ends_with(' ')) out.pop_back();
  return out;
}

std::string as_text(std::string_view text) {
  constexpr std::string_view kKept = "\n\t ";
  std::string out;
  while (!text.empty()) {
    const std::size_t plain = std::min(text.find_first_of(kKept), text.size());
    out += as_line(text.substr(0, plain));
    text.remove_prefix(plain);
    if (text.empty()) break;
    out += text.front();
    text.remove_prefix(1);
  }
  return out;
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  return text;
}

std::string written_out(std::string_view bytes) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  std::string out;
  for (const char each : bytes) {
    const auto byte = static_cast<unsigned char>(each);
    out += "\\x";
    out += kDigits[byte >> 4U];
    out += kDigits[byte & 0xFU];
  }
  return out;
}

}  // namespace reorient

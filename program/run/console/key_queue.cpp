// SPDX-License-Identifier: MIT
#include "program/run/console/key_queue.h"

#include "engine/parameters/utf8.h"

namespace reorient {
namespace {

constexpr char kEscape = '\x1B';
constexpr std::size_t kLongestSequence = 16;

bool is_in(char letter, char first, char last) { return letter >= first && letter <= last; }

/// Length of the escape sequence at the beginning in bytes; 0: more bytes are needed to determine it.
std::size_t sequence_length(std::string_view bytes) {
  if (bytes.size() < 2) return 0;
  if (static_cast<unsigned char>(bytes[1]) < ' ') return 1;  // the Escape key, followed by another key
  if (bytes[1] == 'O') return bytes.size() < 3 ? 0 : 3;
  if (bytes[1] != '[') return 2;
  std::size_t end = 2;
  while (end < bytes.size() && is_in(bytes[end], ' ', '?')) ++end;  // parameters
  if (end >= kLongestSequence) return end;
  if (end == bytes.size()) return 0;
  return is_in(bytes[end], '@', '~') ? end + 1 : end;
}

/// Number of bytes of the UTF-8 letter at the beginning; 0: it needs more bytes; nothing: these bytes begin no letter,
/// as a letter in another encoding does. Must not wait then, because the bytes behind it are other keys.
std::optional<std::size_t> letter_length(std::string_view bytes) {
  const auto code = static_cast<unsigned char>(bytes[0]);
  const std::size_t length = code < 0x80   ? 1
                             : code < 0xC2 ? 0
                             : code < 0xE0 ? 2
                             : code < 0xF0 ? 3
                             : code < 0xF5 ? 4
                                           : 0;
  if (length == 0) return std::nullopt;
  if (bytes.size() >= length) return is_utf8(bytes.substr(0, length)) ? std::optional(length) : std::nullopt;
  for (const char letter : bytes.substr(1))
    if ((static_cast<unsigned char>(letter) & 0xC0U) != 0x80U) return std::nullopt;
  return 0;
}

}  // namespace

std::optional<std::string> KeyQueue::next() {
  while (!bytes_.empty()) {
    const bool is_sequence = bytes_[0] == kEscape;
    const std::optional<std::size_t> length = is_sequence ? sequence_length(bytes_) : letter_length(bytes_);
    if (!length) {
      bytes_.erase(0, 1);
      continue;
    }
    if (*length == 0 || *length > bytes_.size()) return std::nullopt;
    std::string key = bytes_.substr(0, *length);
    bytes_.erase(0, *length);
    if (!is_sequence || sequences_.contains(key)) return key;
  }
  return std::nullopt;
}

}  // namespace reorient

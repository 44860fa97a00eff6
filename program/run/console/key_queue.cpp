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

/// Number of bytes of the UTF-8 letter that begins with this byte.
std::size_t letter_length(char first) {
  const auto code = static_cast<unsigned char>(first);
  return code < 0xC0 ? 1 : code < 0xE0 ? 2 : code < 0xF0 ? 3 : 4;
}

}  // namespace

std::optional<std::string> KeyQueue::next() {
  while (!bytes_.empty()) {
    const bool is_sequence = bytes_[0] == kEscape;
    std::size_t length = is_sequence ? sequence_length(bytes_) : letter_length(bytes_[0]);
    if (length == 0 || length > bytes_.size()) return std::nullopt;
    if (!is_sequence && !is_utf8(std::string_view(bytes_).substr(0, length))) {
      bytes_.erase(0, 1);
      continue;
    }
    std::string key = bytes_.substr(0, length);
    bytes_.erase(0, length);
    if (!is_sequence || sequences_.contains(key)) return key;
  }
  return std::nullopt;
}

}  // namespace reorient

// SPDX-License-Identifier: MIT
// Converts the structures of reorient_companion.h to and from bytes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "robots/companion/reorient_companion.h"

namespace reorient {

/// A message that violates the protocol. The text is one line for the client's developer. The connection ends.
struct BadMessage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Removes a structure from the front. Throws BadMessage if there are too few bytes.
template <typename Message>
Message take_message(std::span<const std::byte>& bytes, const char* what) {
  static_assert(std::is_trivially_copyable_v<Message>);
  if (bytes.size() < sizeof(Message))
    throw BadMessage(std::string(what) + ": expected " + std::to_string(sizeof(Message)) + " bytes, found " +
                     std::to_string(bytes.size()));
  Message message;
  std::memcpy(&message, bytes.data(), sizeof(Message));
  bytes = bytes.subspan(sizeof(Message));
  return message;
}

/// Checks a field that is a sum of bits or a choice. Throws BadMessage: an unknown value has a meaning that would be
/// lost.
inline void check_bits(std::uint32_t value, std::uint32_t known, const char* what) {
  if ((value & ~known) != 0)
    throw BadMessage(std::string(what) + " is " + std::to_string(value) + ", which contains unknown bits (expected " +
                     "a sum of bits of " + std::to_string(known) + ")");
}
inline void check_choice(std::uint32_t value, std::uint32_t most, const char* what) {
  if (value > most)
    throw BadMessage(std::string(what) + " is " + std::to_string(value) + " (expected 0 to " + std::to_string(most) +
                     ")");
}

/// Appends a message with its header.
template <typename Message>
void append_message(std::uint16_t kind, const Message& message, std::vector<std::byte>& bytes) {
  static_assert(std::is_trivially_copyable_v<Message>);
  const reorient_header header{sizeof(Message), kind, REORIENT_VERSION_2};
  const auto append = [&bytes](const auto& part) {
    const auto* const begin = reinterpret_cast<const std::byte*>(&part);
    bytes.insert(bytes.end(), begin, begin + sizeof(part));
  };
  append(header);
  append(message);
}

/// The text of a field, which ends with a zero or at the end of the field.
template <std::size_t Size>
std::string text_of(const char (&field)[Size]) {
  return {field, strnlen(field, Size)};
}

/// Truncates a text that does not fit, but not within a UTF-8 character.
template <std::size_t Size>
void set_text(char (&field)[Size], std::string_view text) {
  std::size_t length = std::min(text.size(), Size - 1);
  while (length > 0 && length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
  std::memset(field, 0, Size);
  std::memcpy(field, text.data(), length);
}

}  // namespace reorient

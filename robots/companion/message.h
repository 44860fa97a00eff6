// SPDX-License-Identifier: MIT
// Messages as they lie in memory: the structures of reorient_companion.h, in and out of bytes.
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

/// What no client of the protocol sends: one line, for whoever wrote it. The connection ends.
struct BadMessage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Takes a structure off the front. Throws BadMessage where there is less.
template <typename Message>
Message take_message(std::span<const std::byte>& bytes, const char* what) {
  static_assert(std::is_trivially_copyable_v<Message>);
  if (bytes.size() < sizeof(Message)) throw BadMessage(std::string(what) + " is cut short");
  Message message;
  std::memcpy(&message, bytes.data(), sizeof(Message));
  bytes = bytes.subspan(sizeof(Message));
  return message;
}

/// With its header.
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

/// Of a text that ends with a zero, or with the field.
template <std::size_t Size>
std::string text_of(const char (&field)[Size]) {
  return {field, strnlen(field, Size)};
}

/// Cut off where it does not fit, never in the middle of a letter.
template <std::size_t Size>
void set_text(char (&field)[Size], std::string_view text) {
  std::size_t length = std::min(text.size(), Size - 1);
  while (length > 0 && length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
  std::memset(field, 0, Size);
  std::memcpy(field, text.data(), length);
}

}  // namespace reorient

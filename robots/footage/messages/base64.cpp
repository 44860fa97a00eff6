// SPDX-License-Identifier: MIT
#include "robots/footage/messages/base64.h"

#include <array>
#include <cstdint>

#include "robots/footage/messages/bad_message.h"

namespace reorient::messages {
namespace {

constexpr std::uint8_t kInvalid = 0xFF;

constexpr std::array<std::uint8_t, 256> values_of_letters() {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::uint8_t, 256> values{};
  for (std::uint8_t& each : values) each = kInvalid;
  for (std::size_t i = 0; i < kLetters.size(); ++i)
    values[static_cast<unsigned char>(kLetters[i])] = static_cast<std::uint8_t>(i);
  return values;
}

}  // namespace

Bytes bytes_of_base64(std::string_view text) {
  static constexpr std::array<std::uint8_t, 256> kValues = values_of_letters();
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  if (text.size() % 4 == 1) fail_at(text.size(), "expected a whole group of base64, found one letter");
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t group = 0;
  int bits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::uint8_t value = kValues[static_cast<unsigned char>(text[i])];
    if (value == kInvalid) fail_at(i, "expected a letter of base64, found " + in_quotes(text.substr(i, 1)));
    group = group << 6 | value;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<std::byte>(group >> bits & 0xFFu));
  }
  return bytes;
}

}  // namespace reorient::messages

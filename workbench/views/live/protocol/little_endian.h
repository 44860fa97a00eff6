// SPDX-License-Identifier: MIT
// Binary messages of the protocol: little-endian numbers and texts after their lengths.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "workbench/views/live/protocol/foxglove_protocol.h"

namespace reorient::live {

static_assert(std::endian::native == std::endian::little, "the byte order in memory must be that of the protocol");

template <std::unsigned_integral Number>
void put_little_endian(Number number, std::byte* to) {
  std::memcpy(to, &number, sizeof number);
}

/// Reads a message of a client. All functions throw BadClientMessage if the message ends too early; `what` names the
/// value.
class BinaryReader {
 public:
  explicit BinaryReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::uint8_t u8(const char* what) { return number<std::uint8_t>(what); }
  std::uint32_t u32(const char* what) { return number<std::uint32_t>(what); }
  std::uint64_t u64(const char* what) { return number<std::uint64_t>(what); }
  float f32(const char* what) { return std::bit_cast<float>(u32(what)); }
  std::string text(std::size_t size, const char* what) {
    require(size, what);
    std::string all(size, '\0');
    if (size > 0) std::memcpy(all.data(), bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
    return all;
  }
  std::string rest() { return text(bytes_.size(), ""); }
  void require_end(const char* message) const {
    if (!bytes_.empty())
      throw BadClientMessage(std::string(message) + ": expected the end of the message, found " +
                             std::to_string(bytes_.size()) + " more bytes");
  }

 private:
  template <typename Number>
  Number number(const char* what) {
    require(sizeof(Number), what);
    Number value{};
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_ = bytes_.subspan(sizeof value);
    return value;
  }
  void require(std::size_t size, const char* what) const {
    if (size > bytes_.size())
      throw BadClientMessage(std::string("binary message: expected ") + what + " (" + std::to_string(size) +
                             " bytes), found the end after " + std::to_string(bytes_.size()));
  }

  std::span<const std::byte> bytes_;
};

/// Writes a message of the server.
class BinaryWriter {
 public:
  explicit BinaryWriter(std::uint8_t opcode) : bytes_{std::byte{opcode}} {}

  template <std::unsigned_integral Number>
  void number(Number value) {
    bytes_.resize(bytes_.size() + sizeof value);
    put_little_endian(value, bytes_.data() + bytes_.size() - sizeof value);
  }
  /// After its length.
  void text(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size()));
    rest(text);
  }
  void rest(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text));
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

}  // namespace reorient::live

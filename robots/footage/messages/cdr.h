// SPDX-License-Identifier: MIT
// Reads the Common Data Representation (OMG DDS-RTPS 10, CDR version 1) in which ROS 2 serializes messages: values are
// aligned to their size, counted from the end of the 4-byte encapsulation header, which names the byte order.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "robots/footage/messages/bad_message.h"

namespace reorient::messages {

class CdrReader {
 public:
  /// Reads the encapsulation header. Throws BadFootage, as all functions do.
  explicit CdrReader(std::span<const std::byte> message);

  /// bool, integers, float and double. `what` names the value in an error.
  template <typename T>
  T number(const char* what) {
    static_assert(std::is_arithmetic_v<T>);
    std::array<std::byte, sizeof(T)> bytes;
    const std::span<const std::byte> stored = aligned(sizeof(T), sizeof(T), what);
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes[i] = stored[swap_ ? sizeof(T) - 1 - i : i];
    if constexpr (std::is_same_v<T, bool>) {
      return bytes[0] != std::byte{0};
    } else {
      return std::bit_cast<T>(bytes);
    }
  }

  template <std::size_t Size>
  std::array<double, Size> doubles(const char* what) {
    std::array<double, Size> numbers;
    for (double& each : numbers) each = number<double>(what);
    return numbers;
  }

  std::vector<double> double_sequence(const char* what);
  std::string text(const char* what);
  /// The result points into the message.
  std::span<const std::byte> bytes(const char* what);
  /// The number of elements that follow, each of at least `least` bytes. It is checked against the rest of the message,
  /// so the caller may reserve memory for them.
  std::size_t sequence_length(std::size_t least, const char* what);

  /// Skips a value.
  void skip(std::size_t size, std::size_t alignment, const char* what) { aligned(size, alignment, what); }

  std::size_t offset() const { return offset_; }  ///< bytes from the start of the message

 private:
  std::span<const std::byte> aligned(std::size_t size, std::size_t alignment, const char* what);

  std::span<const std::byte> message_;
  std::size_t offset_ = 0;
  bool swap_ = false;
};

}  // namespace reorient::messages

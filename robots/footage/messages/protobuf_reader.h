// SPDX-License-Identifier: MIT
// Reads the wire format of Protocol Buffers field by field, within the bytes of one message.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace reorient::messages {

class ProtobufReader {
 public:
  /// `offset`: position of these bytes in the outermost message, for errors.
  explicit ProtobufReader(std::span<const std::byte> message, std::size_t offset = 0)
      : message_(message), outer_(offset) {}

  /// Reads the next field. False: the end of the message. Throws BadFootage, as all functions do.
  bool next();
  std::uint32_t field() const { return field_; }  ///< number of the current field

  // The current field's value. `what` names it in the error for another wire type.
  std::int64_t integer(const char* what) const;  ///< int32, int64
  std::uint32_t fixed32(const char* what) const;
  double number(const char* what) const;
  std::span<const std::byte> bytes(const char* what) const;
  std::string text(const char* what) const;
  ProtobufReader message(const char* what) const { return ProtobufReader(bytes(what), outer_ + value_offset_); }
  /// Appends the current field's elements of a repeated double, packed or single.
  void append_numbers(std::vector<double>& numbers, const char* what) const;

  std::size_t offset() const { return outer_ + field_offset_; }  ///< of the current field

 private:
  enum Wire : std::uint8_t { varint = 0, fixed_64 = 1, length_delimited = 2, fixed_32 = 5 };

  std::uint64_t read_varint();
  std::span<const std::byte> take(std::uint64_t size);
  void expect(Wire wire, const char* what) const;

  std::span<const std::byte> message_;
  std::size_t outer_;
  std::size_t at_ = 0, field_offset_ = 0, value_offset_ = 0;
  std::uint32_t field_ = 0;
  std::uint8_t wire_ = varint;
  std::uint64_t integer_ = 0;         // of a varint
  std::span<const std::byte> value_;  // of all others
};

}  // namespace reorient::messages

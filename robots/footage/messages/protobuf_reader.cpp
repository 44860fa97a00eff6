// SPDX-License-Identifier: MIT
#include "robots/footage/messages/protobuf_reader.h"

#include <bit>
#include <cstring>

#include "robots/footage/messages/bad_message.h"

namespace reorient::messages {
namespace {

static_assert(std::endian::native == std::endian::little, "Protocol Buffers are little-endian");

template <typename T>
T value_of(std::span<const std::byte> bytes) {
  T value;
  std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

}  // namespace

std::uint64_t ProtobufReader::read_varint() {
  const std::size_t start = at_;
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    if (at_ == message_.size()) fail_at(outer_ + start, "expected an integer, found the end of the message");
    const auto byte = std::to_integer<std::uint64_t>(message_[at_++]);
    value |= (byte & 0x7Fu) << shift;
    if (byte < 0x80) return value;
  }
  fail_at(outer_ + start, "expected an integer of at most 10 bytes, found a longer one");
}

std::span<const std::byte> ProtobufReader::take(std::uint64_t size) {
  const std::size_t left = message_.size() - at_;
  if (size > left) {
    fail_at(outer_ + at_, "field " + std::to_string(field_) + ": expected " + std::to_string(size) + " bytes, found " +
                              std::to_string(left));
  }
  value_offset_ = at_;
  at_ += static_cast<std::size_t>(size);
  return message_.subspan(value_offset_, static_cast<std::size_t>(size));
}

bool ProtobufReader::next() {
  if (at_ == message_.size()) return false;
  field_offset_ = at_;
  const std::uint64_t key = read_varint();
  constexpr std::uint64_t kHighestField = (1u << 29) - 1;
  if (key >> 3 == 0 || key >> 3 > kHighestField)
    fail_at(offset(), "expected a field number from 1 to 536870911, found " + std::to_string(key >> 3));
  field_ = static_cast<std::uint32_t>(key >> 3);
  wire_ = static_cast<std::uint8_t>(key & 7u);
  switch (wire_) {
    case Wire::varint:
      integer_ = read_varint();
      return true;
    case Wire::fixed_64:
      value_ = take(8);
      return true;
    case Wire::length_delimited:
      value_ = take(read_varint());
      return true;
    case Wire::fixed_32:
      value_ = take(4);
      return true;
    default:
      fail_at(offset(),
              "field " + std::to_string(field_) + ": expected wire type 0, 1, 2 or 5, found " + std::to_string(wire_));
  }
}

void ProtobufReader::expect(Wire wire, const char* what) const {
  if (wire_ == wire) return;
  fail_at(offset(),
          std::string(what) + ": expected wire type " + std::to_string(wire) + ", found " + std::to_string(wire_));
}

std::int64_t ProtobufReader::integer(const char* what) const {
  expect(Wire::varint, what);
  return static_cast<std::int64_t>(integer_);
}

std::uint32_t ProtobufReader::fixed32(const char* what) const {
  expect(Wire::fixed_32, what);
  return value_of<std::uint32_t>(value_);
}

double ProtobufReader::number(const char* what) const {
  expect(Wire::fixed_64, what);
  return value_of<double>(value_);
}

std::span<const std::byte> ProtobufReader::bytes(const char* what) const {
  expect(Wire::length_delimited, what);
  return value_;
}

std::string ProtobufReader::text(const char* what) const {
  const std::span<const std::byte> found = bytes(what);
  return {reinterpret_cast<const char*>(found.data()), found.size()};
}

void ProtobufReader::append_numbers(std::vector<double>& numbers, const char* what) const {
  if (wire_ == Wire::fixed_64) {
    numbers.push_back(number(what));
    return;
  }
  const std::span<const std::byte> packed = bytes(what);
  if (packed.size() % sizeof(double) != 0) {
    fail_at(offset(), std::string(what) + ": expected a multiple of 8 bytes, found " + std::to_string(packed.size()));
  }
  for (std::size_t i = 0; i < packed.size(); i += sizeof(double))
    numbers.push_back(value_of<double>(packed.subspan(i, sizeof(double))));
}

}  // namespace reorient::messages

// SPDX-License-Identifier: MIT
#include "robots/footage/messages/cdr.h"

#include <algorithm>

namespace reorient::messages {
namespace {

constexpr std::size_t kEncapsulation = 4;  // bytes

}  // namespace

CdrReader::CdrReader(std::span<const std::byte> message) : message_(message) {
  if (message.size() < kEncapsulation)
    fail_at(0, "expected a CDR header of 4 bytes, found " + std::to_string(message.size()));
  const int kind = std::to_integer<int>(message[0]) << 8 | std::to_integer<int>(message[1]);
  constexpr int kBigEndian = 0, kLittleEndian = 1;
  if (kind != kBigEndian && kind != kLittleEndian)
    fail_at(0, "expected CDR of version 1 (0 or 1), found representation " + std::to_string(kind));
  swap_ = (kind == kLittleEndian) != (std::endian::native == std::endian::little);
  offset_ = kEncapsulation;
}

std::span<const std::byte> CdrReader::aligned(std::size_t size, std::size_t alignment, const char* what) {
  const std::size_t padding = (alignment - (offset_ - kEncapsulation) % alignment) % alignment;
  const std::size_t left = message_.size() - offset_;
  if (size > left || padding > left - size) {
    fail_at(offset_, std::string(what) + ": expected " + std::to_string(size) + " bytes, found " +
                         std::to_string(left - std::min(left, padding)));
  }
  const std::span<const std::byte> found = message_.subspan(offset_ + padding, size);
  offset_ += padding + size;
  return found;
}

std::size_t CdrReader::sequence_length(std::size_t least, const char* what) {
  const auto length = number<std::uint32_t>(what);
  const std::size_t left = message_.size() - offset_;
  if (length > left / least) {
    fail_at(offset_ - sizeof(length), std::string(what) + ": expected at most " + std::to_string(left / least) +
                                          " elements, found " + std::to_string(length));
  }
  return length;
}

std::vector<double> CdrReader::double_sequence(const char* what) {
  std::vector<double> numbers(sequence_length(sizeof(double), what));
  for (double& each : numbers) each = number<double>(what);
  return numbers;
}

std::string CdrReader::text(const char* what) {
  // The length includes a terminating zero; some writers leave it out of an empty text.
  const std::size_t length = sequence_length(1, what);
  const std::span<const std::byte> bytes = aligned(length, 1, what);
  if (length == 0) return {};
  if (bytes.back() != std::byte{0})
    fail_at(offset_ - 1, std::string(what) + ": expected the zero that ends a text, found " +
                             std::to_string(std::to_integer<int>(bytes.back())));
  return {reinterpret_cast<const char*>(bytes.data()), length - 1};
}

std::span<const std::byte> CdrReader::bytes(const char* what) { return aligned(sequence_length(1, what), 1, what); }

}  // namespace reorient::messages

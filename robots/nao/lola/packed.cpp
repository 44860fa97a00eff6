// SPDX-License-Identifier: MIT
#include "robots/nao/lola/packed.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace reorient::nao {
namespace {

/// The most significant byte is the first, as everywhere in MessagePack.
std::uint64_t number_from(std::span<const std::byte> bytes) {
  std::uint64_t value = 0;
  for (const std::byte byte : bytes) value = value << 8 | std::to_integer<std::uint64_t>(byte);
  return value;
}

/// The meaning of the first byte of a value.
struct Head {
  PackedKind kind = PackedKind::reserved;
  std::size_t length_bytes = 0;  // length of the number that follows, which is a length or the value itself
  std::uint64_t immediate = 0;   // the number if none follows
};

Head head_of(std::byte byte) {
  const auto first = std::to_integer<std::uint8_t>(byte);
  if (first <= 0x7f) return {PackedKind::positive, 0, first};
  if (first <= 0x8f) return {PackedKind::map, 0, first & 0x0fu};
  if (first <= 0x9f) return {PackedKind::array, 0, first & 0x0fu};
  if (first <= 0xbf) return {PackedKind::text, 0, first & 0x1fu};
  if (first >= 0xe0) return {PackedKind::negative, 0, static_cast<std::uint64_t>(static_cast<std::int8_t>(first))};
  const std::size_t power = std::size_t{1} << (first & 3u);  // bytes of the integers: 1, 2, 4, 8
  switch (first) {
    case 0xc0:
      return {PackedKind::nil, 0, 0};
    case 0xc2:
    case 0xc3:
      return {PackedKind::boolean, 0, first & 1u};
    case 0xc4:
    case 0xc5:
    case 0xc6:
      return {PackedKind::bytes, power, 0};
    case 0xca:
      return {PackedKind::float32, 4, 0};
    case 0xcb:
      return {PackedKind::float64, 8, 0};
    case 0xcc:
    case 0xcd:
    case 0xce:
    case 0xcf:
      return {PackedKind::positive, power, 0};
    case 0xd0:
    case 0xd1:
    case 0xd2:
    case 0xd3:
      return {PackedKind::negative, power, 0};
    case 0xd9:
    case 0xda:
    case 0xdb:
      return {PackedKind::text, std::size_t{1} << (first - 0xd9u), 0};
    case 0xdc:
    case 0xdd:
      return {PackedKind::array, std::size_t{2} << (first - 0xdcu), 0};
    case 0xde:
    case 0xdf:
      return {PackedKind::map, std::size_t{2} << (first - 0xdeu), 0};
    default:  // 0xc1 is never used, and LoLA sends no extensions
      return {};
  }
}

}  // namespace

PackedExtent first_packed_value(std::span<const std::byte> bytes) {
  using State = PackedExtent::State;
  constexpr std::uint64_t kMostValues = 1 << 16;  // that may be missing; deeper nesting is invalid
  std::size_t at = 0;
  for (std::uint64_t missing = 1; missing > 0; --missing) {
    if (at >= bytes.size()) return {State::cut_short, 0};
    const Head head = head_of(bytes[at++]);
    if (head.kind == PackedKind::reserved) return {State::invalid, 0};
    if (bytes.size() - at < head.length_bytes) return {State::cut_short, 0};
    const std::uint64_t number =
        head.length_bytes == 0 ? head.immediate : number_from(bytes.subspan(at, head.length_bytes));
    at += head.length_bytes;
    if (head.kind == PackedKind::map || head.kind == PackedKind::array) {
      missing += head.kind == PackedKind::map ? 2 * number : number;
      if (missing > kMostValues) return {State::invalid, 0};
    } else if (head.kind == PackedKind::text || head.kind == PackedKind::bytes) {
      if (bytes.size() - at < number) return {State::cut_short, 0};
      at += static_cast<std::size_t>(number);
    }
  }
  return {State::whole, at};
}

/// Removes the first byte and its number. Returns the meaning of the byte and the number in it or after it.
std::optional<PackedReader::Beginning> PackedReader::begin(std::initializer_list<PackedKind> kinds) {
  if (rest_.empty()) return std::nullopt;
  const Head head = head_of(rest_.front());
  if (std::find(kinds.begin(), kinds.end(), head.kind) == kinds.end() || rest_.size() <= head.length_bytes) {
    rest_ = {};
    return std::nullopt;
  }
  const std::uint64_t number =
      head.length_bytes == 0 ? head.immediate : number_from(rest_.subspan(1, head.length_bytes));
  rest_ = rest_.subspan(1 + head.length_bytes);
  return Beginning{head.kind, head.length_bytes, number};
}

std::optional<std::uint32_t> PackedReader::map() {
  const std::optional<Beginning> map = begin({PackedKind::map});
  return map ? std::optional(static_cast<std::uint32_t>(map->number)) : std::nullopt;
}

std::optional<std::uint32_t> PackedReader::array() {
  const std::optional<Beginning> array = begin({PackedKind::array});
  return array ? std::optional(static_cast<std::uint32_t>(array->number)) : std::nullopt;
}

std::optional<float> PackedReader::number() {
  const std::optional<Beginning> value = begin(
      {PackedKind::positive, PackedKind::negative, PackedKind::float32, PackedKind::float64, PackedKind::boolean});
  if (!value) return std::nullopt;
  switch (value->kind) {
    case PackedKind::float32:
      return std::bit_cast<float>(static_cast<std::uint32_t>(value->number));
    case PackedKind::float64: {
      constexpr double kMost = std::numeric_limits<float>::max();
      const double wide = std::bit_cast<double>(value->number);
      return std::fabs(wide) > kMost ? std::numeric_limits<float>::infinity() : static_cast<float>(wide);
    }
    case PackedKind::negative: {
      const unsigned unused = value->bytes == 0 ? 0u : 64u - 8u * static_cast<unsigned>(value->bytes);
      return static_cast<float>(static_cast<std::int64_t>(value->number << unused) >> unused);
    }
    default:
      return static_cast<float>(value->number);
  }
}

std::optional<std::string_view> PackedReader::text() {
  const std::optional<Beginning> length = begin({PackedKind::text, PackedKind::bytes});
  if (!length || rest_.size() < length->number) {
    rest_ = {};
    return std::nullopt;
  }
  const auto size = static_cast<std::size_t>(length->number);
  const std::string_view text(reinterpret_cast<const char*>(rest_.data()), size);
  rest_ = rest_.subspan(size);
  return text;
}

bool PackedReader::skip() {
  const PackedExtent extent = first_packed_value(rest_);
  if (extent.state != PackedExtent::State::whole) {
    rest_ = {};
    return false;
  }
  rest_ = rest_.subspan(extent.size);
  return true;
}

void PackedWriter::put(std::uint64_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t at = size_++;
    if (at < buffer_.size()) buffer_[at] = static_cast<std::byte>(value >> (8 * (size - 1 - i)));
  }
}

void PackedWriter::map(std::uint32_t pairs) {
  if (pairs < 16) return put(0x80u | pairs, 1);
  put(0xde, 1);
  put(pairs, 2);
}

void PackedWriter::array(std::uint32_t values) {
  if (values < 16) return put(0x90u | values, 1);
  put(0xdc, 1);
  put(values, 2);
}

void PackedWriter::text(std::string_view text) {
  put(0xa0u | (text.size() & 0x1fu), 1);
  for (const char letter : text.substr(0, 0x1f)) put(static_cast<std::uint8_t>(letter), 1);
}

void PackedWriter::number(float value) {
  put(0xca, 1);
  put(std::bit_cast<std::uint32_t>(value), 4);
}

void PackedWriter::small(std::uint8_t value) { put(value & 0x7fu, 1); }

void PackedWriter::boolean(bool value) { put(value ? 0xc3 : 0xc2, 1); }

}  // namespace reorient::nao

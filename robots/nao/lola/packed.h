// SPDX-License-Identifier: MIT
// The part of MessagePack that LoLA uses, without heap memory: read in place, written into a buffer. The input may be
// arbitrary bytes: the reader never accesses memory outside the given bytes, and checks each length against them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>

namespace reorient::nao {

enum class PackedKind { map, array, text, bytes, positive, negative, float32, float64, boolean, nil, reserved };

/// The length of the first value in some bytes.
struct PackedExtent {
  enum class State { whole, cut_short, invalid } state = State::invalid;
  std::size_t size = 0;  ///< bytes, if it is whole
};
PackedExtent first_packed_value(std::span<const std::byte> bytes);

/// Reads one value after another. After an error, every further call returns nothing.
class PackedReader {
 public:
  explicit PackedReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  /// Number of pairs of key and value that follow; nothing if this is not a map.
  std::optional<std::uint32_t> map();
  /// Number of values that follow; nothing if this is not an array.
  std::optional<std::uint32_t> array();
  /// A number of any type, or a Boolean as 0 or 1; may be NaN. Returns nothing for other types.
  std::optional<float> number();
  /// Valid as long as the bytes. Returns nothing if this is not a text.
  std::optional<std::string_view> text();
  /// Skips one value of any type. Returns false if no value is left.
  bool skip();

  std::span<const std::byte> rest() const { return rest_; }

 private:
  struct Beginning {
    PackedKind kind;
    std::size_t bytes;  // length of the number; 0: it is part of the first byte
    std::uint64_t number;
  };
  std::optional<Beginning> begin(std::initializer_list<PackedKind> kinds);

  std::span<const std::byte> rest_;
};

/// Writes into a buffer. Values that do not fit are left out, and `size` is then greater than the buffer.
class PackedWriter {
 public:
  explicit PackedWriter(std::span<std::byte> buffer) : buffer_(buffer) {}

  void map(std::uint32_t pairs);
  void array(std::uint32_t values);
  void text(std::string_view text);  ///< at most 31 bytes, so that decoders of any MessagePack version can read it
  void number(float value);
  void small(std::uint8_t value);  ///< at most 127
  void boolean(bool value);

  std::size_t size() const { return size_; }

 private:
  void put(std::uint64_t value, std::size_t size);

  std::span<std::byte> buffer_;
  std::size_t size_ = 0;
};

}  // namespace reorient::nao

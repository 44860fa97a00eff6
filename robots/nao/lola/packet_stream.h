// SPDX-License-Identifier: MIT
// Extracts whole packets from a stream of bytes: a packet may arrive in pieces, and several may arrive at once.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace reorient::nao {

class PacketStream {
 public:
  static constexpr std::size_t kLongest = 8192;  // bytes of a packet; those of LoLA have about a ninth of it

  /// Where to write the next bytes; never empty after next() has returned `waiting`.
  std::span<std::byte> space() { return std::span(bytes_).subspan(end_); }
  /// Call with the number of bytes that were written there.
  void written(std::size_t size) { end_ += size; }

  enum class State { packet, waiting, invalid };
  /// Sets `packet` to the oldest whole packet, valid until the next call. Returns `invalid` if the bytes are not a
  /// packet or the packet is too long: then close the connection, because later packets cannot be found either.
  State next(std::span<const std::byte>& packet);

  void clear() { begin_ = end_ = 0; }

 private:
  std::array<std::byte, 4 * kLongest> bytes_{};
  std::size_t begin_ = 0, end_ = 0;  // of the bytes that were not read yet
};

}  // namespace reorient::nao

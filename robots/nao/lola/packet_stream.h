// SPDX-License-Identifier: MIT
// Whole packets out of a stream of bytes: a packet may come in pieces, and several may come at once.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace reorient::nao {

class PacketStream {
 public:
  static constexpr std::size_t kLongest = 8192;  // bytes of a packet: nine times LoLA's

  /// Where the next bytes are to be written to; never empty after next() has said that there is no whole packet.
  std::span<std::byte> space() { return std::span(bytes_).subspan(end_); }
  /// So many were written there.
  void written(std::size_t size) { end_ += size; }

  enum class State { packet, waiting, nonsense };
  /// The oldest whole packet, valid until the next call. `nonsense`: what came is no packet, or has no end; nothing
  /// that follows can be read either, and the connection is of no more use.
  State next(std::span<const std::byte>& packet);

  void clear() { begin_ = end_ = 0; }

 private:
  std::array<std::byte, 4 * kLongest> bytes_{};
  std::size_t begin_ = 0, end_ = 0;  // of what was not taken yet
};

}  // namespace reorient::nao

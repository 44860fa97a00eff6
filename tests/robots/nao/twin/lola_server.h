// SPDX-License-Identifier: MIT
// LoLA's socket in real time: one client, a packet to it each cycle, its commands in between.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "robots/nao/lola/command.h"
#include "robots/nao/lola/packet_stream.h"

namespace reorient::nao {

inline constexpr long kCycleNanoseconds = 12'000'000;

/// ns, of the monotonic clock.
long monotonic_nanoseconds();

class LolaServer {
 public:
  struct Counts {
    long answers = 0;   ///< that came before the next packet
    long missed = 0;    ///< packets without one
    long slowest = 0;   ///< ns from a packet to its answer
    long nonsense = 0;  ///< what was no command
    long connections = 0;
  };

  /// Throws std::system_error where the socket cannot be had.
  explicit LolaServer(const char* path);
  ~LolaServer();
  LolaServer(const LolaServer&) = delete;
  LolaServer& operator=(const LolaServer&) = delete;

  bool has_client() const { return client_ >= 0; }
  /// Returns true if a new client has connected.
  bool welcome();
  void hang_up();

  /// A cycle begins: what was sent before and not answered is missed.
  void begin_cycle();
  /// In two writes where `first` is less than all.
  void send(std::span<const std::byte> packet, std::size_t first);
  /// Until then.
  void hear(long until, const std::function<void(const Command&)>& take);

  const Counts& counts() const { return counts_; }

 private:
  bool put(std::span<const std::byte> bytes) const;

  int listener_ = -1, client_ = -1;
  PacketStream stream_;
  bool awaits_ = false;
  long sent_at_ = 0;
  Counts counts_;
};

}  // namespace reorient::nao

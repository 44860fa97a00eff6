// SPDX-License-Identifier: MIT
// A server like LoLA, in real time: it sends a packet to its client in each cycle and receives the client's commands.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "robots/nao/lola/command.h"
#include "robots/nao/lola/packet_stream.h"

namespace reorient::nao {

inline constexpr long kCycleNanoseconds = 12'000'000;

/// Time of the monotonic clock, ns.
long monotonic_nanoseconds();

class LolaServer {
 public:
  struct Counts {
    long answers = 0;   ///< that arrived before the next packet
    long missed = 0;    ///< packets without an answer
    long slowest = 0;   ///< longest time from a packet to its answer, ns
    long nonsense = 0;  ///< packets that are not commands
    long connections = 0;
  };

  /// Throws std::system_error if the socket cannot be created.
  explicit LolaServer(const char* path);
  ~LolaServer();
  LolaServer(const LolaServer&) = delete;
  LolaServer& operator=(const LolaServer&) = delete;

  bool has_client() const { return client_ >= 0; }
  /// Returns true if a new client has connected.
  bool welcome();
  void hang_up();

  /// Starts a cycle. A previous packet without an answer counts as missed.
  void begin_cycle();
  /// Sends a packet, in two writes if `first` is less than its size.
  void send(std::span<const std::byte> packet, std::size_t first);
  /// Receives commands until this time (ns).
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

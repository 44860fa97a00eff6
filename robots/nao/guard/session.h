// SPDX-License-Identifier: MIT
// One connection with LoLA as bytes: received bytes in, bytes to send out. It has no clock and no socket.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "robots/nao/guard/guard.h"
#include "robots/nao/guard/shared_body.h"
#include "robots/nao/lola/command_packet.h"
#include "robots/nao/lola/packet_stream.h"
#include "robots/nao/lola/sensor_packet.h"

namespace reorient::nao {

class Session {
 public:
  /// `body`: receives measurements and reports, and provides requests.
  explicit Session(SharedBody& body) : body_(body) {}

  void connected();
  void disconnected();

  /// Write received bytes to space(), then call received() with their number and their arrival time (s, monotonic). If
  /// several packets arrive at once, the newest is answered. received() returns false if the bytes are not LoLA's: then
  /// close the connection.
  std::span<std::byte> space() { return stream_.space(); }
  bool received(std::size_t size, double time);

  /// Send the bytes of to_send(), then call sent() with the number that was sent at `time`. A partly sent answer is
  /// completed first; an answer of which nothing was sent is replaced by a newer one.
  std::span<const std::byte> to_send() const { return std::span(answer_).subspan(sent_, answer_size_ - sent_); }
  void sent(std::size_t size, double time);

  void finish();
  bool is_at_rest() const { return guard_.is_at_rest(); }
  GuardReport report(double time) const;

 private:
  void answer();
  void read_walk();

  SharedBody& body_;
  Guard guard_;
  Guard before_;  // state before the answer that waits to be sent
  PacketStream stream_;
  SensorReader reader_;
  Measurement measurement_;
  std::optional<BodyRequest> request_;
  std::optional<WalkTargets> walk_;
  GuardReport counts_;
  std::array<std::byte, kCommandBytes> answer_{}, next_{};
  std::size_t answer_size_ = 0, sent_ = 0;
  bool has_next_ = false;
  double answered_time_ = 0.0, next_time_ = 0.0;  // s, arrival of the packet that is answered
};

}  // namespace reorient::nao

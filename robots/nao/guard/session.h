// SPDX-License-Identifier: MIT
// One connection with LoLA as bytes: what it sent goes in, what it is to be sent comes out. Neither clock nor socket.
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
  /// `body`: where measurements and reports go, and where requests come from.
  explicit Session(SharedBody& body) : body_(body) {}

  void connected();
  void disconnected();

  /// Where what LoLA sends is to be written to, and that so much of it has come at `time` (s, monotonic). Of several
  /// packets at once the newest is answered. False: it is no LoLA that speaks there, or all hope is lost: hang up.
  std::span<std::byte> space() { return stream_.space(); }
  bool received(std::size_t size, double time);

  /// What is to be sent, and that so much of it was sent at `time`. An answer that was begun is ended; one that was not
  /// is replaced by a newer one.
  std::span<const std::byte> to_send() const { return std::span(answer_).subspan(sent_, answer_size_ - sent_); }
  void sent(std::size_t size, double time);

  void finish();
  bool is_at_rest() const { return guard_.is_at_rest(); }
  GuardReport report(double time) const;

 private:
  void answer();
  void hear_walk();

  SharedBody& body_;
  Guard guard_;
  Guard before_;  // the answer that waits to be sent
  PacketStream stream_;
  SensorReader reader_;
  Measurement measurement_;
  std::optional<BodyRequest> request_;
  std::optional<WalkTargets> walk_;
  GuardReport counts_;
  std::array<std::byte, kCommandBytes> answer_{}, next_{};
  std::size_t answer_size_ = 0, sent_ = 0;
  bool has_next_ = false;
  double answered_time_ = 0.0, next_time_ = 0.0;  // s, when the packet had come that is answered
};

}  // namespace reorient::nao

// SPDX-License-Identifier: MIT
// The wireless network of a simulated team: it loses messages, and delivers the others late.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/random.h"
#include "robots/robot.h"

namespace reorient {

struct NetworkParameters {
  double loss = 0.1;
  double delay = 0.05;
  double delay_spread = 0.05;
};

template <typename Visit>
void describe(NetworkParameters& p, Visit&& visit) {
  visit("loss", p.loss, 0.0, 1.0, "", "fraction of the team messages that a receiver does not get");
  visit("delay", p.delay, 0.0, 10.0, "s", "shortest time until a team message arrives");
  visit("delay_spread", p.delay_spread, 0.0, 10.0, "s",
        "largest time that is added at random to the delay, so that messages may change their order");
}

class TeamNetwork {
 public:
  TeamNetwork(const NetworkParameters& parameters, std::uint64_t seed)
      : parameters_(parameters), random_(seed, kStream) {}

  /// Sends a message at `time` (s) to one receiver, which is the index of a robot.
  void send(double time, std::size_t receiver, const Message& message);
  /// Removes and returns the messages that arrive at the receiver up to `time`, in the order of their arrival.
  std::vector<Message> take(double time, std::size_t receiver);

  std::uint64_t sent() const { return sent_; }
  std::uint64_t lost() const { return lost_; }

 private:
  struct Underway {
    double due = 0.0;  // s
    std::size_t receiver = 0;
    Message message;
  };
  static constexpr std::uint64_t kStream = 0x2e7;

  NetworkParameters parameters_;
  Random random_;
  std::vector<Underway> underway_;  // in the order of arrival
  std::uint64_t sent_ = 0, lost_ = 0;
};

}  // namespace reorient

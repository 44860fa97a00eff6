// SPDX-License-Identifier: MIT
// Receives the GameController's datagrams from the network.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include <netinet/in.h>

#include "robots/nao/nao.h"

namespace reorient::nao {

/// Receives from each sender until accept_sender(); then only from that sender, until it sends nothing for 10 s. Throws
/// std::runtime_error with one line if the port cannot be opened.
class UdpReferee : public RefereePort {
 public:
  /// `now`: s, monotonic.
  UdpReferee(std::uint16_t port, std::uint16_t return_port, std::function<double()> now);
  ~UdpReferee() override;
  UdpReferee(const UdpReferee&) = delete;
  UdpReferee& operator=(const UdpReferee&) = delete;

  std::span<const std::byte> receive() override;
  void accept_sender() override;
  void answer(std::span<const std::byte> datagram) override;

 private:
  int socket_ = -1;
  std::uint16_t return_port_;
  std::function<double()> now_;
  sockaddr_in from_{};                 // sender of the last datagram
  std::optional<in_addr_t> accepted_;  // address of the accepted sender
  double heard_ = 0.0;                 // s, time of the last datagram that was accepted
  std::array<std::byte, 512> datagram_{};
};

}  // namespace reorient::nao

// SPDX-License-Identifier: MIT
#include "robots/nao/udp_referee.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

namespace reorient::nao {

UdpReferee::UdpReferee(std::uint16_t port, std::uint16_t return_port, std::function<double()> now)
    : socket_(socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)),
      return_port_(return_port),
      now_(std::move(now)) {
  sockaddr_in any{};
  any.sin_family = AF_INET;
  any.sin_port = htons(port);
  any.sin_addr.s_addr = htonl(INADDR_ANY);
  const int yes = 1;
  if (socket_ >= 0) setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  if (socket_ < 0 || bind(socket_, reinterpret_cast<const sockaddr*>(&any), sizeof(any)) != 0) {
    const std::string why = std::strerror(errno);
    if (socket_ >= 0) close(socket_);
    throw std::runtime_error("UDP port " + std::to_string(port) + " for the GameController: " + why +
                             "; leave out --team, or stop the process that uses the port");
  }
}

UdpReferee::~UdpReferee() { close(socket_); }

std::span<const std::byte> UdpReferee::receive() {
  constexpr double kSilent = 10.0;  // s
  constexpr int kAtOnce = 100;      // limits the time that a flood of datagrams takes
  for (int i = 0; i < kAtOnce; ++i) {
    sockaddr_in from{};
    socklen_t length = sizeof(from);
    const ssize_t size = recvfrom(socket_, datagram_.data(), datagram_.size(), MSG_DONTWAIT,
                                  reinterpret_cast<sockaddr*>(&from), &length);
    if (size < 0) return {};
    constexpr std::size_t kHeader = 4;
    if (static_cast<std::size_t>(size) < kHeader || std::memcmp(datagram_.data(), "RGme", kHeader) != 0) continue;
    const bool is_other = accepted_ && *accepted_ != from.sin_addr.s_addr;
    if (is_other && now_() - heard_ < kSilent) continue;
    from_ = from;
    return std::span(datagram_).first(static_cast<std::size_t>(size));
  }
  return {};
}

void UdpReferee::accept_sender() {
  accepted_ = from_.sin_addr.s_addr;
  heard_ = now_();
}

void UdpReferee::answer(std::span<const std::byte> datagram) {
  sockaddr_in to = from_;
  to.sin_port = htons(return_port_);
  static_cast<void>(!sendto(socket_, datagram.data(), datagram.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
                            reinterpret_cast<const sockaddr*>(&to), sizeof(to)));
}

}  // namespace reorient::nao

// SPDX-License-Identifier: MIT
#include "workbench/views/live/server/sockets.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

namespace reorient::live {
namespace {

struct Endpoint {
  std::string address;
  int port = 0;
};

using NameFunction = int (*)(int, sockaddr*, socklen_t*);

/// Of a TCP socket; nothing for any other descriptor.
std::optional<Endpoint> endpoint(int descriptor, NameFunction name_of) {
  sockaddr_storage storage{};
  socklen_t size = sizeof storage;
  auto* const any = reinterpret_cast<sockaddr*>(&storage);
  if (name_of(descriptor, any, &size) != 0) return std::nullopt;
  std::array<char, INET6_ADDRSTRLEN> text{};
  if (storage.ss_family == AF_INET) {
    const auto& address = reinterpret_cast<const sockaddr_in&>(storage);
    inet_ntop(AF_INET, &address.sin_addr, text.data(), text.size());
    return Endpoint{text.data(), ntohs(address.sin_port)};
  }
  if (storage.ss_family != AF_INET6) return std::nullopt;
  const auto& address = reinterpret_cast<const sockaddr_in6&>(storage);
  inet_ntop(AF_INET6, &address.sin6_addr, text.data(), text.size());
  return Endpoint{text.data(), ntohs(address.sin6_port)};
}

/// The sockets of this process with this port of their own.
std::vector<int> sockets_at(int port) {
  std::vector<int> sockets;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const std::string name = entry.path().filename();
    int descriptor = -1;
    std::from_chars(name.data(), name.data() + name.size(), descriptor);
    const std::optional<Endpoint> own = endpoint(descriptor, getsockname);
    if (own && own->port == port) sockets.push_back(descriptor);
  }
  return sockets;
}

}  // namespace

int find_connection(int port, const std::string& peer_address, int peer_port) {
  for (const int socket : sockets_at(port)) {
    const std::optional<Endpoint> peer = endpoint(socket, getpeername);
    if (peer && peer->port == peer_port && peer->address == peer_address) return socket;
  }
  return -1;
}

void shut_down_port(int port) {
  for (const bool listening : {true, false}) {  // first those that accept connections, so that no more come
    for (const int socket : sockets_at(port)) {
      int accepts = 0;
      socklen_t size = sizeof accepts;
      getsockopt(socket, SOL_SOCKET, SO_ACCEPTCONN, &accepts, &size);
      if ((accepts != 0) == listening) shutdown(socket, SHUT_RDWR);
    }
  }
}

bool send_all(int socket, std::span<const std::byte> bytes, const std::function<bool()>& is_given_up) {
  constexpr int kPause = 100;  // ms
  while (!bytes.empty()) {
    const ssize_t sent = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(sent));
      continue;
    }
    if (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR) return false;
    if (is_given_up()) return false;
    pollfd waiting{socket, POLLOUT, 0};
    poll(&waiting, 1, kPause);
  }
  return true;
}

void notice_vanished_peer(int socket) {
  constexpr unsigned kLongest = 60'000;  // ms without an acknowledgment
  setsockopt(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, &kLongest, sizeof kLongest);
  constexpr int kIdle = 30, kEvery = 10;  // s
  setsockopt(socket, IPPROTO_TCP, TCP_KEEPIDLE, &kIdle, sizeof kIdle);
  setsockopt(socket, IPPROTO_TCP, TCP_KEEPINTVL, &kEvery, sizeof kEvery);
}

}  // namespace reorient::live

// SPDX-License-Identifier: MIT
#include "tests/robots/nao/twin/lola_server.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

#include "robots/nao/lola/command_packet.h"

namespace reorient::nao {

long monotonic_nanoseconds() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return 1'000'000'000L * time.tv_sec + time.tv_nsec;
}

LolaServer::LolaServer(const char* path) : listener_(socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::snprintf(address.sun_path, sizeof(address.sun_path), "%s", path);
  unlink(path);
  if (bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0 || listen(listener_, 1) != 0)
    throw std::system_error(errno, std::generic_category(), path);
}

LolaServer::~LolaServer() {
  hang_up();
  close(listener_);
}

bool LolaServer::welcome() {
  if (client_ >= 0) return false;
  client_ = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (client_ < 0) return false;
  ++counts_.connections;
  stream_.clear();
  awaits_ = false;
  return true;
}

void LolaServer::hang_up() {
  if (client_ >= 0) close(client_);
  client_ = -1;
}

void LolaServer::begin_cycle() {
  if (awaits_) ++counts_.missed;
  awaits_ = false;
}

bool LolaServer::put(std::span<const std::byte> bytes) const {
  return ::send(client_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL) ==
             static_cast<ssize_t>(bytes.size()) ||
         errno == EAGAIN;
}

void LolaServer::send(std::span<const std::byte> packet, std::size_t first) {
  if (!put(packet.first(first)) || (first < packet.size() && !put(packet.subspan(first)))) return hang_up();
  sent_at_ = monotonic_nanoseconds();
  awaits_ = true;
}

void LolaServer::hear(long until, const std::function<void(const Command&)>& take) {
  while (true) {
    const long left = until - monotonic_nanoseconds();
    if (left <= 0) return;
    pollfd wait{client_, POLLIN, 0};
    const timespec patience{0, left};
    if (ppoll(&wait, client_ >= 0 ? 1 : 0, &patience, nullptr) <= 0) continue;
    const std::span<std::byte> space = stream_.space();
    const ssize_t size = recv(client_, space.data(), space.size(), MSG_DONTWAIT);
    if (size <= 0 && !(size < 0 && (errno == EAGAIN || errno == EINTR))) {
      hang_up();
      continue;
    }
    if (size <= 0) continue;
    stream_.written(static_cast<std::size_t>(size));
    std::span<const std::byte> packet;
    PacketStream::State state{};
    while ((state = stream_.next(packet)) == PacketStream::State::packet) {
      Command command;
      if (!read_command_packet(packet, command)) ++counts_.nonsense;
      take(command);
      const long took = monotonic_nanoseconds() - sent_at_;
      if (awaits_ && took < kCycleNanoseconds) {
        awaits_ = false;
        counts_.slowest = std::max(counts_.slowest, took);
        ++counts_.answers;
      }
    }
    if (state == PacketStream::State::invalid) {
      ++counts_.nonsense;
      hang_up();
    }
  }
}

}  // namespace reorient::nao

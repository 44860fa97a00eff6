// SPDX-License-Identifier: MIT
#include "robots/companion/connection.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace reorient {
namespace {

constexpr double kSilent = 2.0;            // s without data after which a new client replaces the present one
constexpr std::size_t kPiece = 64 * 1024;  // bytes that are read at once

sockaddr_un address_of(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string text = path.string();
  if (text.empty() || text.size() >= sizeof(address.sun_path))
    throw std::runtime_error("--socket " + text + ": path of " + std::to_string(text.size()) +
                             " bytes (expected 1 to " + std::to_string(sizeof(address.sun_path) - 1) + ")");
  std::copy(text.begin(), text.end(), address.sun_path);
  return address;
}

OwnedDescriptor new_socket() {
  OwnedDescriptor made(socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!made) throw std::runtime_error("cannot create a socket: " + std::string(strerror(errno)));
  return made;
}

const sockaddr* generic(const sockaddr_un& address) { return reinterpret_cast<const sockaddr*>(&address); }

/// Locks the folder, so that checking for a listener, removing an old socket and listening are one step for other
/// companions. The lock lasts as long as the descriptor is open. If another program holds it for long, continue without
/// it, since two companions seldom start at the same time.
OwnedDescriptor lock_folder_of(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  OwnedDescriptor opened(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  constexpr int kTries = 100;  // in 1 s
  for (int i = 0; opened && i < kTries && flock(opened.get(), LOCK_EX | LOCK_NB) != 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return opened;
}

/// Removes the socket of an earlier companion of this user, which no process uses any more. Throws if the file may be
/// anything else: only a refused connection shows that no process has bound the socket, of whatever type it is.
void remove_left_socket(const std::filesystem::path& path, const sockaddr_un& address) {
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0) return;
  if (!S_ISSOCK(status.st_mode))
    throw std::runtime_error("--socket " + path.string() +
                             ": expected a socket or no file, found another file; choose another path");
  const OwnedDescriptor probe = new_socket();
  const int error = connect(probe.get(), generic(address), sizeof(address)) == 0 ? 0 : errno;
  if (error == 0 || error == EAGAIN)
    throw std::runtime_error("--socket " + path.string() +
                             ": another companion listens there; stop it or choose another path");
  if (error != ECONNREFUSED || status.st_uid != geteuid())
    throw std::runtime_error("--socket " + path.string() +
                             ": expected no file or an unused socket of this user, found a socket of another program; "
                             "choose another path");
  unlink(path.c_str());
}

bool is_same_user(int client) {
  ucred peer{};
  socklen_t size = sizeof(peer);
  return getsockopt(client, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 && (peer.uid == geteuid() || peer.uid == 0);
}

/// Whether the client disconnected, also if unread data is left.
bool has_hung_up(int client) {
  pollfd look{client, 0, 0};
  return poll(&look, 1, 0) == 1 && (look.revents & (POLLHUP | POLLERR)) != 0;
}

}  // namespace

Connection::Connection(std::filesystem::path path, std::function<double()> now)
    : path_(std::move(path)),
      now_(std::move(now)),
      listener_(new_socket()),
      in_(sizeof(reorient_header) + REORIENT_LONGEST_BODY + kPiece) {
  const sockaddr_un address = address_of(path_);
  const OwnedDescriptor lock = lock_folder_of(path_);
  remove_left_socket(path_, address);
  constexpr int kWaiting = 4;
  // The socket's mode is that of its file from the first moment on (unix(7) names only the umask, which is the
  // process's).
  if (fchmod(listener_.get(), 0600) != 0 || bind(listener_.get(), generic(address), sizeof(address)) != 0 ||
      ::listen(listener_.get(), kWaiting) != 0)
    throw std::runtime_error("--socket " + path_.string() + ": " + strerror(errno));
  lstat(path_.c_str(), &made_);
}

/// Removes the socket only if it is still this one: another process may listen there by now.
Connection::~Connection() {
  const OwnedDescriptor lock = lock_folder_of(path_);
  struct stat status {};
  const bool is_ours =
      lstat(path_.c_str(), &status) == 0 && status.st_dev == made_.st_dev && status.st_ino == made_.st_ino;
  if (is_ours) unlink(path_.c_str());
}

void Connection::refuse(const std::string& why, Receiver& receiver) {
  if (!client_) return;
  refuse(client_, why, receiver);
  drop(receiver);
}

void Connection::listen(double seconds, Receiver& receiver) {
  if (std::exchange(gone_, false)) drop(receiver);
  std::array<pollfd, 2> waits{{{listener_.get(), POLLIN, 0}, {client_.get(), POLLIN, 0}}};
  if (client_ && sent_ < out_.size()) waits[1].events |= POLLOUT;
  const int ready = poll(waits.data(), client_ ? 2 : 1, static_cast<int>(1000.0 * seconds));
  if (ready <= 0) return;
  if (client_ && (waits[1].revents & POLLOUT) != 0) flush();
  if (client_ && (waits[1].revents & (POLLIN | POLLHUP | POLLERR)) != 0) read_messages(receiver);
  if ((waits[0].revents & POLLIN) != 0) accept_clients(receiver);
}

void Connection::accept_clients(Receiver& receiver) {
  constexpr int kAtOnce = 8;
  for (int i = 0; i < kAtOnce; ++i) {
    OwnedDescriptor client(accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!client) return;
    if (!is_same_user(client.get())) {
      refuse(client, "only processes of the companion's user or of root may connect", receiver);
    } else if (client_ && !has_hung_up(client_.get()) && now_() - last_heard_ < kSilent) {
      refuse(client, "another client is connected and sent data within the last 2 s", receiver);
    } else {
      if (client_) drop(receiver);
      client_ = std::move(client);
      last_heard_ = now_();
      receiver.connected();
    }
  }
}

/// A refusal has the same layout in each version, so that a client of another version can read the reason.
void Connection::refuse(OwnedDescriptor& client, const std::string& why, Receiver& receiver, std::uint16_t version) {
  receiver.refused(why);
  reorient_refusal refusal{};
  set_text(refusal.why, why);
  std::vector<std::byte> bytes;
  append_message(REORIENT_REFUSAL, refusal, bytes);
  const reorient_header header{sizeof(refusal), REORIENT_REFUSAL, version};
  std::memcpy(bytes.data(), &header, sizeof(header));
  static_cast<void>(::send(client.get(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL));
}

void Connection::drop(Receiver& receiver) {
  client_ = OwnedDescriptor();
  memory_ = OwnedDescriptor();
  received_ = 0;
  out_.clear();
  sent_ = 0;
  gone_ = false;
  receiver.disconnected();
}

void Connection::read_messages(Receiver& receiver) {
  constexpr std::size_t kAtOnce = 64 * kPiece;  // limits a client that sends without end
  for (std::size_t total = 0; total < kAtOnce;) {
    union {
      cmsghdr header;
      char bytes[CMSG_SPACE(4 * sizeof(int))];
    } control;
    iovec part{in_.data() + received_, kPiece};
    msghdr all{};
    all.msg_iov = &part;
    all.msg_iovlen = 1;
    all.msg_control = &control;
    all.msg_controllen = sizeof(control);
    const ssize_t got = recvmsg(client_.get(), &all, MSG_DONTWAIT | MSG_CMSG_CLOEXEC);
    const int why = errno;
    if (got >= 0) {
      for (cmsghdr* header = CMSG_FIRSTHDR(&all); header != nullptr; header = CMSG_NXTHDR(&all, header)) {
        if (header->cmsg_level != SOL_SOCKET || header->cmsg_type != SCM_RIGHTS) continue;
        const std::size_t count = (header->cmsg_len - CMSG_LEN(0)) / sizeof(int);
        for (std::size_t i = 0; i < count; ++i) {
          int descriptor = -1;
          std::memcpy(&descriptor, CMSG_DATA(header) + i * sizeof(int), sizeof(int));
          // The descriptor may be anything. A network socket could block close() until its peer responds.
          const linger none{0, 0};
          setsockopt(descriptor, SOL_SOCKET, SO_LINGER, &none, sizeof(none));
          memory_ = OwnedDescriptor(descriptor);  // the last one is used, the others are closed
        }
      }
    }
    if (got < 0 && (why == EAGAIN || why == EWOULDBLOCK || why == EINTR)) return;
    if (got <= 0) return drop(receiver);
    total += static_cast<std::size_t>(got);
    received_ += static_cast<std::size_t>(got);
    last_heard_ = now_();
    if (!take_whole_messages(receiver)) return;
    if (static_cast<std::size_t>(got) < kPiece) return;
  }
}

/// Returns false if the client has disconnected.
bool Connection::take_whole_messages(Receiver& receiver) {
  std::span<const std::byte> rest = std::span(in_).first(received_);
  std::uint16_t version = REORIENT_VERSION_2;
  try {
    while (rest.size() >= sizeof(reorient_header)) {
      std::span<const std::byte> bytes = rest;
      const auto header = take_message<reorient_header>(bytes, "a header");
      version = header.version;
      if (version != REORIENT_VERSION_2)
        throw BadMessage("expected protocol version 2, found version " + std::to_string(version));
      if (header.size > REORIENT_LONGEST_BODY)
        throw BadMessage("message of " + std::to_string(header.size) + " bytes (expected at most 65536)");
      if (bytes.size() < header.size) break;
      receiver.receive(header.kind, bytes.first(header.size), memory_);
      rest = bytes.subspan(header.size);
    }
  } catch (const BadMessage& bad) {
    refuse(client_, bad.what(), receiver, version);
    drop(receiver);
    return false;
  }
  std::memmove(in_.data(), rest.data(), rest.size());
  received_ = rest.size();
  return true;
}

/// Returns false if data is left or the client has disconnected.
bool Connection::flush() {
  while (sent_ < out_.size()) {
    const ssize_t sent = ::send(client_.get(), out_.data() + sent_, out_.size() - sent_, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent > 0) {
      sent_ += static_cast<std::size_t>(sent);
    } else if (sent < 0 && errno == EINTR) {
      continue;
    } else {
      if (errno != EAGAIN && errno != EWOULDBLOCK) gone_ = true;
      return false;
    }
  }
  out_.clear();
  sent_ = 0;
  return true;
}

std::filesystem::path default_socket_path() {
  const char* const folder = std::getenv("XDG_RUNTIME_DIR");
  if (folder != nullptr && *folder != '\0') return std::filesystem::path(folder) / "reorient.sock";
  return "/tmp/reorient-" + std::to_string(geteuid()) + ".sock";
}

}  // namespace reorient

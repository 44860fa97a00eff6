// SPDX-License-Identifier: MIT
// A UNIX socket at which one client of the same user is served: whole messages come out of it, and what is sent never
// waits. What a client does ends its own connection at most.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sys/stat.h>

#include "robots/companion/message.h"
#include "robots/companion/shared_images.h"

namespace reorient {

/// Who listens to a connection.
class Receiver {
 public:
  virtual ~Receiver() = default;
  virtual void connected() = 0;
  /// One message; `memory`: the file descriptor that came with it, if any. Throws BadMessage: the client is told why,
  /// and gone.
  virtual void receive(std::uint16_t kind, std::span<const std::byte> body, OwnedDescriptor& memory) = 0;
  virtual void disconnected() = 0;
};

class Connection {
 public:
  /// Listens: whoever may write to the file, mode 0600, can connect. `now`: s, for how long a client has been silent.
  /// Throws std::runtime_error with one line: the path is too long, is no socket, or somebody else listens there.
  Connection(std::filesystem::path path, std::function<double()> now);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Takes what has come, for at most `seconds` until something does. A signal ends the wait.
  void listen(double seconds, Receiver& receiver);

  bool has_client() const { return static_cast<bool>(client_); }
  /// The client is told why, and gone.
  void refuse(const std::string& why, Receiver& receiver);
  /// False: there is no client, or it has not read what was sent before; then all of it is left out.
  template <typename Message>
  bool send(std::uint16_t kind, const Message& message) {
    if (!client_ || !flush()) return false;
    append_message(kind, message, out_);
    flush();
    return static_cast<bool>(client_);
  }

 private:
  void accept_clients(Receiver& receiver);
  void read_messages(Receiver& receiver);
  bool take_whole_messages(Receiver& receiver);
  void refuse(OwnedDescriptor& client, const std::string& why, std::uint16_t version = REORIENT_VERSION_2) const;
  void drop(Receiver& receiver);
  bool flush();

  std::filesystem::path path_;
  struct stat made_ {};  // the socket's file
  std::function<double()> now_;
  OwnedDescriptor listener_;
  OwnedDescriptor client_;
  bool gone_ = false;          // found out while sending; the receiver is told next time
  double last_heard_ = 0.0;    // s
  std::vector<std::byte> in_;  // of one size: room for the longest message and one more piece
  std::size_t received_ = 0;   // bytes of in_ that no message has taken yet
  std::vector<std::byte> out_;
  std::size_t sent_ = 0;    // of out_
  OwnedDescriptor memory_;  // came, and no message has taken it yet
};

/// Where to listen if nobody says otherwise: in the user's own folder for such things.
std::filesystem::path default_socket_path();

}  // namespace reorient

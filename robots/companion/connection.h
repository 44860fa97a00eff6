// SPDX-License-Identifier: MIT
// A UNIX socket at which one client of the same user is served: whole messages come out of it, and sending never
// blocks. An error of a client ends at most its own connection.
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

/// Receives the messages of a connection.
class Receiver {
 public:
  virtual ~Receiver() = default;
  virtual void connected() = 0;
  /// One message; `memory`: the file descriptor that came with it, if any. After a BadMessage the client is refused
  /// with its text and disconnected.
  virtual void receive(std::uint16_t kind, std::span<const std::byte> body, OwnedDescriptor& memory) = 0;
  virtual void disconnected() = 0;
  /// A client is refused, the connected one or another one. disconnected() follows for the connected one.
  virtual void refused(const std::string& why) = 0;
};

class Connection {
 public:
  /// Listens: processes that may write to the file (mode 0600) can connect. `now`: s, to measure how long a client
  /// sends nothing. Throws std::runtime_error with one line: path too long, not a socket, or another process listens
  /// there.
  Connection(std::filesystem::path path, std::function<double()> now);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Waits at most `seconds` for data, and delivers all messages that have arrived. A signal ends the wait.
  void listen(double seconds, Receiver& receiver);

  bool has_client() const { return static_cast<bool>(client_); }
  /// Sends the reason to the client and disconnects it.
  void refuse(const std::string& why, Receiver& receiver);
  /// Returns false and sends nothing if no client is connected or it has not read the previous data.
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
  static void refuse(OwnedDescriptor& client, const std::string& why, Receiver& receiver,
                     std::uint16_t version = REORIENT_VERSION_2);
  void drop(Receiver& receiver);
  bool flush();

  std::filesystem::path path_;
  struct stat made_ {};  // the socket's file
  std::function<double()> now_;
  OwnedDescriptor listener_;
  OwnedDescriptor client_;
  bool gone_ = false;          // sending has failed; listen() notifies the receiver
  double last_heard_ = 0.0;    // s, time of the last data
  std::vector<std::byte> in_;  // constant size: the longest message and one more piece
  std::size_t received_ = 0;   // bytes in in_ that are not processed yet
  std::vector<std::byte> out_;
  std::size_t sent_ = 0;    // bytes of out_ that were sent
  OwnedDescriptor memory_;  // arrived, but its message has not
};

/// Default path of the socket: in the user's runtime folder.
std::filesystem::path default_socket_path();

}  // namespace reorient

// SPDX-License-Identifier: MIT
// A viewer of the live view over a real socket, which can also break every rule.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "tests/waiting.h"
#include "tests/workbench/views/live/client_frames.h"

namespace reorient::live {

/// A message of the server.
struct Received {
  int opcode = 0;
  std::string data;
  nlohmann::json json() const { return nlohmann::json::parse(data, nullptr, false); }
};

class TestViewer {
 public:
  explicit TestViewer(int port, int receive_buffer = 0) {
    socket_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (receive_buffer > 0) setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    is_connected_ = connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    host_ = "127.0.0.1:" + std::to_string(port);
  }
  ~TestViewer() { close(); }
  TestViewer(const TestViewer&) = delete;
  TestViewer& operator=(const TestViewer&) = delete;

  void close() {
    if (socket_ >= 0) ::close(std::exchange(socket_, -1));
  }
  bool is_connected() const { return is_connected_; }
  const std::string& host() const { return host_; }

  void send_bytes(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t sent = send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent <= 0) return;
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
  }

  /// Sends a request and returns the head of the response with what follows it, up to the end of the connection for
  /// anything but a WebSocket.
  std::string request(const std::string& target, const std::string& headers, const std::string& method = "GET") {
    send_bytes(method + " " + target + " HTTP/1.1\r\n" + headers + "\r\n");
    while (received_.find("\r\n\r\n") == std::string::npos && receive_more()) {
    }
    const std::size_t end = received_.find("\r\n\r\n");
    std::string head = received_.substr(0, end);
    if (head.find(" 101 ") != std::string::npos) {
      received_.erase(0, end + 4);
      return head;
    }
    while (receive_more()) {
    }
    return std::exchange(received_, "");
  }
  /// The handshake of a WebSocket. `more`: headers, each with its line end.
  std::string open(const std::string& token, const std::string& subprotocols = "foxglove.websocket.v1",
                   const std::string& more = "", std::string host = "", const std::string& path = "/") {
    if (host.empty()) host = host_;
    return request(path + (token.empty() ? "" : "?token=" + token),
                   "Host: " + host + "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n" +
                       "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
                       (subprotocols.empty() ? "" : "Sec-WebSocket-Protocol: " + subprotocols + "\r\n") + more);
  }

  void send_text(const std::string& text) const { send_bytes(client_frame(kTextFrame, text)); }
  void send_json(const nlohmann::json& json) const { send_text(json.dump()); }
  void call(std::uint32_t service, std::uint32_t call, const std::string& payload,
            const std::string& encoding = "json") const {
    std::string bytes(1, '\x02');
    for (const auto number : {service, call, static_cast<std::uint32_t>(encoding.size())})
      bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    send_bytes(client_frame(kBinaryFrame, bytes + encoding + payload));
  }

  /// The next message; nothing: the connection has ended, or kWaitLimit passed. Answers pings, if `answers_pings`.
  std::optional<Received> receive() {
    while (true) {
      std::optional<Received> message = take_message();
      if (!message && !receive_more()) return std::nullopt;
      if (message && message->opcode != kPingFrame) return message;
      if (message && answers_pings) send_bytes(client_frame(kPongFrame, message->data));
    }
  }
  bool answers_pings = false;  ///< as every correct client does, so that the server measures the connection
  /// The next message for which `is_it` is true; nothing: the connection has ended before.
  std::optional<Received> await(const std::function<bool(const Received&)>& is_it) {
    while (std::optional<Received> message = receive()) {
      if (is_it(*message)) return message;
    }
    return std::nullopt;
  }
  /// The next JSON message with this operation.
  nlohmann::json await_operation(const std::string& operation) {
    const auto found =
        await([&](const Received& one) { return one.opcode == kTextFrame && one.json().value("op", "") == operation; });
    return found ? found->json() : nlohmann::json();
  }
  /// The response of a service, or its failure.
  nlohmann::json await_response(std::uint32_t call) { return await_responses({call})[call]; }
  /// The same for calls that may be answered in any order.
  std::map<std::uint32_t, nlohmann::json> await_responses(std::set<std::uint32_t> calls) {
    constexpr std::size_t kHead = 17;
    std::map<std::uint32_t, nlohmann::json> responses;
    await([&](const Received& one) {
      nlohmann::json response;
      std::uint32_t call = 0;
      if (one.opcode == kTextFrame) {
        response = one.json();
        if (response.value("op", "") != "serviceCallFailure") return false;
        call = response.value("callId", 0u);
      } else {
        if (one.data.size() < kHead || one.data[0] != 3) return false;
        std::memcpy(&call, one.data.data() + 5, sizeof call);
        response = nlohmann::json::parse(one.data.substr(kHead), nullptr, false);
      }
      if (calls.erase(call) > 0) responses[call] = std::move(response);
      return calls.empty();
    });
    return responses;
  }
  /// Reads until the server ends the connection. Returns the reason of its close frame.
  std::string await_close() {
    std::string reason;
    while (const std::optional<Received> message = receive()) {
      if (message->opcode == kCloseFrame && message->data.size() > 2) reason = message->data.substr(2);
    }
    return reason;
  }

 private:
  bool receive_more() {
    pollfd waiting{socket_, POLLIN, 0};
    const auto limit = std::chrono::duration_cast<std::chrono::milliseconds>(kWaitLimit).count();
    if (poll(&waiting, 1, static_cast<int>(limit)) != 1) return false;
    std::array<char, 65536> bytes{};
    const ssize_t size = recv(socket_, bytes.data(), bytes.size(), 0);
    if (size <= 0) return false;
    received_.append(bytes.data(), static_cast<std::size_t>(size));
    return true;
  }
  std::optional<Received> take_message() {
    const auto at = [this](std::size_t i) { return static_cast<unsigned char>(received_[i]); };
    if (received_.size() < 2) return std::nullopt;
    std::size_t size = at(1) & 127, head = 2;
    const std::size_t bytes = size == 126 ? 2 : size == 127 ? 8 : 0;
    if (received_.size() < 2 + bytes) return std::nullopt;
    if (bytes > 0) size = 0;
    for (; head < 2 + bytes; ++head) size = size << 8 | at(head);
    if (received_.size() < head + size) return std::nullopt;
    Received message{at(0) & 15, received_.substr(head, size)};
    received_.erase(0, head + size);
    return message;
  }

  int socket_ = -1;
  bool is_connected_ = false;
  std::string host_;
  std::string received_;
};

}  // namespace reorient::live

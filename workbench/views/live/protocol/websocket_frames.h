// SPDX-License-Identifier: MIT
// Frames of WebSocket (RFC 6455) as values: those of a client are put together to messages of bounded size.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace reorient::live {

enum class WebSocketType : std::uint8_t { text = 1, binary = 2, close = 8, ping = 9, pong = 10 };

struct WebSocketMessage {
  WebSocketType type = WebSocketType::text;
  std::vector<std::byte> data;
};

/// Codes of a close frame.
inline constexpr std::uint16_t kNormalClose = 1000, kProtocolError = 1002, kNotUtf8 = 1007, kPolicyViolation = 1008,
                               kTooLarge = 1009;

/// Collects the bytes of one client.
class WebSocketReader {
 public:
  /// `largest`: bytes of a message, of all its fragments together.
  explicit WebSocketReader(std::size_t largest) : largest_(largest) {}

  void add(std::span<const std::byte> bytes);

  /// The next whole message; nothing: more bytes are needed, or failure() is not empty.
  std::optional<WebSocketMessage> next();

  /// One line: why the client breaks the protocol, so that its connection must be closed; empty: it does not.
  const std::string& failure() const { return failure_; }
  std::uint16_t failure_code() const { return failure_code_; }

 private:
  struct Frame {
    bool is_last = false;
    std::uint8_t opcode = 0;
    std::size_t head = 0, size = 0;  // bytes
    std::array<std::byte, 4> mask{};
  };
  std::optional<Frame> read_head();
  std::optional<WebSocketMessage> take(const Frame& frame);
  std::nullopt_t fail(std::uint16_t code, std::string reason);

  std::span<const std::byte> unread() const { return std::span(bytes_).subspan(read_); }

  std::size_t largest_;
  std::vector<std::byte> bytes_;
  std::size_t read_ = 0;  // bytes of complete frames at the beginning
  std::optional<WebSocketMessage> begun_;
  std::string failure_;
  std::uint16_t failure_code_ = 0;
};

/// The bytes before the `size` bytes of an unfragmented message of the server.
std::vector<std::byte> websocket_head(WebSocketType type, std::size_t size);

/// A whole close frame; the reason is truncated to the 123 bytes that the protocol allows.
std::vector<std::byte> websocket_close(std::uint16_t code, const std::string& reason);

}  // namespace reorient::live

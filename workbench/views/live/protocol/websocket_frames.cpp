// SPDX-License-Identifier: MIT
#include "workbench/views/live/protocol/websocket_frames.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "engine/parameters/utf8.h"

namespace reorient::live {
namespace {

constexpr std::size_t kLargestControl = 125;

std::uint64_t big_endian(std::span<const std::byte> bytes) {
  std::uint64_t number = 0;
  for (const std::byte byte : bytes) number = number << 8 | std::to_integer<std::uint64_t>(byte);
  return number;
}

void append_big_endian(std::uint64_t number, int count, std::vector<std::byte>& bytes) {
  for (int i = count - 1; i >= 0; --i) bytes.push_back(static_cast<std::byte>(number >> (8 * i) & 0xFF));
}

bool is_valid_text(const WebSocketMessage& message) {
  return message.type != WebSocketType::text ||
         is_utf8({reinterpret_cast<const char*>(message.data.data()), message.data.size()});
}

}  // namespace

void WebSocketReader::add(std::span<const std::byte> bytes) {
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(std::exchange(read_, 0)));
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

std::nullopt_t WebSocketReader::fail(std::uint16_t code, std::string reason) {
  failure_ = std::move(reason);
  failure_code_ = code;
  bytes_ = {};
  read_ = 0;
  begun_.reset();
  return std::nullopt;
}

/// The head of the next frame, if it is whole and valid.
std::optional<WebSocketReader::Frame> WebSocketReader::read_head() {
  const std::span<const std::byte> bytes = unread();
  if (bytes.size() < 2) return std::nullopt;
  const auto first = std::to_integer<std::uint8_t>(bytes[0]), second = std::to_integer<std::uint8_t>(bytes[1]);
  Frame frame{(first & 0x80) != 0, static_cast<std::uint8_t>(first & 0x0F)};
  if ((first & 0x70) != 0) return fail(kProtocolError, "WebSocket: expected no extension, found reserved bits");
  if ((second & 0x80) == 0) return fail(kProtocolError, "WebSocket: expected a masked frame, found an unmasked one");
  const bool is_control = frame.opcode >= 8;
  if (frame.opcode > 10 || (frame.opcode > 2 && !is_control))
    return fail(kProtocolError, "WebSocket: unknown opcode " + std::to_string(frame.opcode));
  const std::size_t short_size = second & 0x7F;
  if (is_control && (short_size > kLargestControl || !frame.is_last))
    return fail(kProtocolError, "WebSocket: expected a control frame of at most 125 bytes in one part");
  if (!is_control && (frame.opcode == 0) != begun_.has_value())
    return fail(kProtocolError, begun_ ? "WebSocket: expected the next fragment, found another message"
                                       : "WebSocket: expected a message, found a fragment without beginning");
  const std::size_t size_bytes = short_size == 126 ? 2 : short_size == 127 ? 8 : 0;
  frame.head = 2 + size_bytes + frame.mask.size();
  if (bytes.size() < 2 + size_bytes) return std::nullopt;
  const std::uint64_t size = size_bytes == 0 ? short_size : big_endian(bytes.subspan(2, size_bytes));
  // Before its bytes arrive, so that no client can occupy more memory.
  if (size > largest_ || (!is_control && begun_ && begun_->data.size() + size > largest_))
    return fail(kTooLarge, "WebSocket: expected messages of at most " + std::to_string(largest_) + " bytes, found " +
                               std::to_string(size));
  frame.size = static_cast<std::size_t>(size);
  if (bytes.size() < frame.head + frame.size) return std::nullopt;
  std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(2 + size_bytes), frame.mask.size(), frame.mask.begin());
  return frame;
}

/// The message that ends with this frame; nothing: more fragments follow.
std::optional<WebSocketMessage> WebSocketReader::take(const Frame& frame) {
  const std::span<const std::byte> data = unread().subspan(frame.head, frame.size);
  WebSocketMessage message{static_cast<WebSocketType>(frame.opcode), {}};
  const bool continues = frame.opcode == 0;
  if (continues) message = std::move(*std::exchange(begun_, std::nullopt));
  message.data.reserve(message.data.size() + data.size());
  for (std::size_t i = 0; i < data.size(); ++i) message.data.push_back(data[i] ^ frame.mask[i % frame.mask.size()]);
  read_ += frame.head + frame.size;
  if (!frame.is_last) {
    begun_ = std::move(message);
    return std::nullopt;
  }
  if (!is_valid_text(message)) return fail(kNotUtf8, "WebSocket: expected text in UTF-8, found other bytes");
  return message;
}

std::optional<WebSocketMessage> WebSocketReader::next() {
  while (failure_.empty()) {
    const std::optional<Frame> frame = read_head();
    if (!frame) return std::nullopt;
    if (std::optional<WebSocketMessage> message = take(*frame)) return message;
  }
  return std::nullopt;
}

std::vector<std::byte> websocket_head(WebSocketType type, std::size_t size) {
  std::vector<std::byte> head{std::byte{0x80} | static_cast<std::byte>(type)};
  if (size <= kLargestControl) {
    head.push_back(static_cast<std::byte>(size));
  } else if (size <= 0xFFFF) {
    head.push_back(std::byte{126});
    append_big_endian(size, 2, head);
  } else {
    head.push_back(std::byte{127});
    append_big_endian(size, 8, head);
  }
  return head;
}

std::vector<std::byte> websocket_close(std::uint16_t code, const std::string& reason) {
  std::string_view text = std::string_view(reason).substr(0, kLargestControl - 2);
  while (!is_utf8(text)) text.remove_suffix(1);
  std::vector<std::byte> frame = websocket_head(WebSocketType::close, text.size() + 2);
  append_big_endian(code, 2, frame);
  const auto bytes = std::as_bytes(std::span(text));
  frame.insert(frame.end(), bytes.begin(), bytes.end());
  return frame;
}

}  // namespace reorient::live

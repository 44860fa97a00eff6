// SPDX-License-Identifier: MIT
// Frames of WebSocket: messages arrive whole however they are cut, and a client that breaks the protocol or sends too
// much is refused.
#include "workbench/views/live/protocol/websocket_frames.h"

#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/workbench/views/live/client_frames.h"

namespace reorient::live {
namespace {

std::string text_of(const WebSocketMessage& message) {
  return {reinterpret_cast<const char*>(message.data.data()), message.data.size()};
}

void add(WebSocketReader& reader, const std::string& bytes) { reader.add(std::as_bytes(std::span(bytes))); }

std::uint16_t failure_of(const std::string& bytes, std::size_t largest = 100) {
  WebSocketReader reader(largest);
  add(reader, bytes);
  while (reader.next()) {
  }
  EXPECT_EQ(reader.failure().empty(), reader.failure_code() == 0);
  return reader.failure_code();
}

RC_GTEST_PROP(WebSocketReader, ReadsMessagesHoweverTheyAreCut, (const std::vector<std::string>& messages)) {
  std::string stream;
  for (const std::string& message : messages) stream += client_frame(kBinaryFrame, message);
  WebSocketReader reader(std::size_t{1} << 20);
  std::vector<std::string> read;
  while (!stream.empty()) {
    const auto size = *rc::gen::inRange<std::size_t>(1, stream.size() + 1);
    add(reader, stream.substr(0, size));
    stream.erase(0, size);
    while (const auto message = reader.next()) read.push_back(text_of(*message));
  }
  RC_ASSERT(reader.failure().empty());
  RC_ASSERT(read == messages);
}

TEST(WebSocketReader, ReadsLongMessages) {
  for (const std::size_t size : {125u, 126u, 127u, 65535u, 65536u, 100000u}) {
    WebSocketReader reader(100000);
    add(reader, client_frame(kTextFrame, std::string(size, 'x')));
    const auto message = reader.next();
    ASSERT_TRUE(message) << size;
    EXPECT_EQ(message->data.size(), size);
    EXPECT_EQ(message->type, WebSocketType::text);
  }
}

TEST(WebSocketReader, PutsFragmentsTogetherAroundAPing) {
  WebSocketReader reader(100);
  add(reader, client_frame(kTextFrame, "one ", false) + client_frame(kPingFrame, "?") +
                  client_frame(kContinuation, "two ", false) + client_frame(kContinuation, "three"));
  const auto ping = reader.next();
  ASSERT_TRUE(ping);
  EXPECT_EQ(ping->type, WebSocketType::ping);
  const auto whole = reader.next();
  ASSERT_TRUE(whole);
  EXPECT_EQ(text_of(*whole), "one two three");
  EXPECT_EQ(whole->type, WebSocketType::text);
}

TEST(WebSocketReader, RefusesMessagesThatAreTooLargeBeforeTheyArrive) {
  EXPECT_EQ(failure_of(client_frame(kBinaryFrame, std::string(100, 'x'))), 0);
  EXPECT_EQ(failure_of(client_frame(kBinaryFrame, std::string(101, 'x'))), kTooLarge);
  EXPECT_EQ(failure_of(std::string("\x82\xFE\x10\x00", 4)), kTooLarge) << "only the size has arrived";
  EXPECT_EQ(failure_of("\x82\xFF" + std::string(8, '\xFF')), kTooLarge);
  EXPECT_EQ(failure_of(client_frame(kBinaryFrame, std::string(60, 'x'), false) +
                       client_frame(kContinuation, std::string(60, 'x'))),
            kTooLarge)
      << "all fragments together";
}

TEST(WebSocketReader, RefusesWhatTheProtocolForbids) {
  EXPECT_EQ(failure_of(std::string("\x81\x01x", 3)), kProtocolError) << "unmasked";
  EXPECT_EQ(failure_of(std::string("\xC1\x80", 2)), kProtocolError) << "reserved bits";
  EXPECT_EQ(failure_of(client_frame(3, "")), kProtocolError) << "an opcode without a meaning";
  EXPECT_EQ(failure_of(client_frame(11, "")), kProtocolError) << "a control opcode without a meaning";
  EXPECT_EQ(failure_of(client_frame(kPingFrame, "", false)), kProtocolError) << "a control frame in parts";
  EXPECT_EQ(failure_of(client_frame(kPingFrame, std::string(126, 'x'), true), 1000), kProtocolError);
  EXPECT_EQ(failure_of(client_frame(kContinuation, "x")), kProtocolError) << "a fragment without beginning";
  EXPECT_EQ(failure_of(client_frame(kTextFrame, "x", false) + client_frame(kTextFrame, "y")), kProtocolError);
  EXPECT_EQ(failure_of(client_frame(kTextFrame, "\xFF")), kNotUtf8);
}

TEST(WebSocketReader, ReadsNothingAfterAFailure) {
  WebSocketReader reader(100);
  add(reader, client_frame(kTextFrame, "\xFF") + client_frame(kTextFrame, "x"));
  EXPECT_FALSE(reader.next());
  add(reader, client_frame(kTextFrame, "x"));
  EXPECT_FALSE(reader.next());
}

TEST(WebSocketHead, HasTheShortestForm) {
  EXPECT_EQ(websocket_head(WebSocketType::text, 125).size(), 2u);
  EXPECT_EQ(websocket_head(WebSocketType::binary, 126).size(), 4u);
  EXPECT_EQ(websocket_head(WebSocketType::binary, 65535).size(), 4u);
  EXPECT_EQ(websocket_head(WebSocketType::binary, 65536).size(), 10u);
  EXPECT_EQ(websocket_head(WebSocketType::binary, 65536)[0], std::byte{0x82});
}

TEST(WebSocketClose, TruncatesItsReasonToWholeLetters) {
  const std::vector<std::byte> frame = websocket_close(kPolicyViolation, std::string(122, 'x') + "\xC3\xA4");
  EXPECT_EQ(frame.size(), 2u + 2u + 122u);
  EXPECT_EQ(frame[2], std::byte{0x03});
  EXPECT_EQ(frame[3], std::byte{0xF0});
}

}  // namespace
}  // namespace reorient::live

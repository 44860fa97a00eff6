// SPDX-License-Identifier: MIT
// The web server with real connections: pages, handshakes, hostile clients, and its end.
#include "workbench/views/live/server/web_server.h"

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/waiting.h"
#include "tests/workbench/views/live/test_viewer.h"
#include "workbench/views/live/protocol/foxglove_protocol.h"
#include "workbench/views/live/server/compression.h"

namespace reorient::live {
namespace {

const std::string kRightToken(32, 'a');

/// Answers each message with its size.
class Echo : public ViewerSession {
 public:
  Echo(std::shared_ptr<ViewerMailbox> mailbox, std::atomic<int>& sessions)
      : mailbox_(std::move(mailbox)), sessions_(sessions) {
    ++sessions_;
  }
  ~Echo() override { --sessions_; }
  void receive_text(std::string_view text) override { mailbox_->add_control("text " + std::to_string(text.size())); }
  void receive_binary(std::span<const std::byte> bytes) override {
    mailbox_->add_control("binary " + std::to_string(bytes.size()));
  }

 private:
  std::shared_ptr<ViewerMailbox> mailbox_;
  std::atomic<int>& sessions_;
};

class ServedPage : public ::testing::Test {
 protected:
  void start(int most_viewers = 4) {
    WebServerOptions options{.port = 0, .token = kRightToken, .most_viewers = most_viewers};
    server.emplace(
        options, [this](std::string_view path) { return path == "/" ? &page : nullptr; },
        [this](const std::shared_ptr<ViewerMailbox>& mailbox, const Access& /*access*/) {
          const std::lock_guard lock(mutex);
          mailboxes.push_back(mailbox);
          return std::make_unique<Echo>(mailbox, sessions);
        });
  }
  double stop() {
    const auto begin = std::chrono::steady_clock::now();
    server->stop("the end");
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  std::string get(const std::string& target, const std::string& headers = "Host: localhost\r\n",
                  const std::string& method = "GET") const {
    return TestViewer(server->port()).request(target, headers, method);
  }

  ServedFile page{"text/html; charset=utf-8", "<p>page"};
  std::mutex mutex;
  std::vector<std::shared_ptr<ViewerMailbox>> mailboxes;
  std::atomic<int> sessions = 0;
  std::optional<WebServer> server;
};

TEST_F(ServedPage, HasASafeHead) {
  start();
  const std::string response = get("/");
  EXPECT_TRUE(response.starts_with("HTTP/1.1 200 ")) << response;
  EXPECT_TRUE(response.ends_with("\r\n\r\n<p>page")) << response;
  for (const char* header :
       {"Content-Security-Policy: default-src 'none'; script-src 'self'", "X-Content-Type-Options: nosniff",
        "Cache-Control: no-store", "Referrer-Policy: no-referrer", "Content-Type: text/html; charset=utf-8"})
    EXPECT_NE(response.find(header), std::string::npos) << header;
  EXPECT_EQ(response.find("unsafe-eval"), std::string::npos);
  EXPECT_TRUE(get("/?token=x").starts_with("HTTP/1.1 200 ")) << "the page itself is no secret";
  EXPECT_TRUE(get("/", "Host: localhost\r\n", "HEAD").ends_with("\r\n\r\n"));
}

TEST_F(ServedPage, IsCompressedForABrowserThatAcceptsIt) {
  const std::string compressed = gzip(page.text);
  page.gzip = compressed;
  start();
  for (const char* accepted : {"gzip", "deflate, gzip;q=1.0, *;q=0.5", "br , GZIP ; q=0.1"}) {
    const std::string response = get("/", std::string("Host: localhost\r\nAccept-Encoding: ") + accepted + "\r\n");
    EXPECT_TRUE(response.ends_with("\r\n\r\n" + compressed)) << accepted;
    EXPECT_NE(response.find("\r\nContent-Encoding: gzip\r\n"), std::string::npos) << accepted;
    EXPECT_NE(response.find("\r\nVary: Accept-Encoding\r\n"), std::string::npos) << accepted;
    EXPECT_NE(response.find("\r\nContent-Length: " + std::to_string(compressed.size()) + "\r\n"), std::string::npos);
  }
  for (const char* accepted : {"identity", "gzip;q=0", "", ";;,,;q=1", "gzipped", "*"}) {
    const std::string response = get("/", std::string("Host: localhost\r\nAccept-Encoding: ") + accepted + "\r\n");
    EXPECT_TRUE(response.ends_with("\r\n\r\n<p>page")) << accepted;
    EXPECT_EQ(response.find("Content-Encoding"), std::string::npos) << accepted;
  }
}

TEST_F(ServedPage, IsTheOnlyFile) {
  start();
  for (const char* target :
       {"/x", "/../../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/..%2f..%2fetc/passwd", "//etc/passwd",
        "/./etc/passwd", "/proc/self/environ", "/index.html%00", "/C:\\", "/page/index.html"}) {
    const std::string response = get(target);
    EXPECT_TRUE(response.starts_with("HTTP/1.1 404 ") || response.starts_with("HTTP/1.1 400 ")) << target << response;
    EXPECT_EQ(response.find("root:"), std::string::npos);
  }
}

TEST_F(ServedPage, RefusesOtherHostsAndMethods) {
  start();
  EXPECT_TRUE(get("/", "Host: evil.example\r\n").starts_with("HTTP/1.1 403 "));
  EXPECT_TRUE(get("/", "").starts_with("HTTP/1.1 4"));
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS"})
    EXPECT_TRUE(get("/", "Host: localhost\r\n", method).starts_with("HTTP/1.1 405 ")) << method;
}

TEST_F(ServedPage, AcceptsBothSubprotocols) {
  start();
  for (const auto& [offered, taken] : {std::pair{"foxglove.websocket.v1", "foxglove.websocket.v1"},
                                       {"foxglove.sdk.v1", "foxglove.sdk.v1"},
                                       {"foxglove.websocket.v1, foxglove.sdk.v1", "foxglove.websocket.v1"},
                                       {"chat,foxglove.sdk.v1,foxglove.websocket.v1", "foxglove.sdk.v1"}}) {
    TestViewer viewer(server->port());
    const std::string head = viewer.open("", offered);
    EXPECT_TRUE(head.starts_with("HTTP/1.1 101 ")) << head;
    EXPECT_NE((head + "\r\n").find(std::string("Sec-WebSocket-Protocol: ") + taken + "\r\n"), std::string::npos)
        << head;
  }
}

TEST_F(ServedPage, RefusesOtherSubprotocolsWithATextThatNamesBoth) {
  start();
  for (const char* offered : {"", "chat", "foxglove.websocket.v2, chat"}) {
    const std::string response = TestViewer(server->port()).open(kRightToken, offered);
    EXPECT_TRUE(response.starts_with("HTTP/1.1 400 ")) << response;
    for (const std::string_view name : kSubprotocols) EXPECT_NE(response.find(name), std::string::npos);
  }
}

TEST_F(ServedPage, AnswersMessagesInOnePieceOrMany) {
  start();
  TestViewer viewer(server->port());
  viewer.open("");
  viewer.send_text("four");
  EXPECT_EQ(viewer.receive()->data, "text 4");
  for (const char byte : client_frame(kBinaryFrame, std::string(300, 'x'))) viewer.send_bytes({&byte, 1});
  EXPECT_EQ(viewer.receive()->data, "binary 300");
  viewer.send_bytes(client_frame(kPingFrame, "?"));
  const auto pong = viewer.receive();
  EXPECT_EQ(pong->opcode, 10);
  EXPECT_EQ(pong->data, "?");
  viewer.send_bytes(client_frame(kCloseFrame, "\x03\xE8"));
  viewer.await_close();
  EXPECT_TRUE(await([&] { return sessions == 0; }));
}

TEST_F(ServedPage, EndsAConnectionThatBreaksTheProtocol) {
  start();
  for (const std::string& bad :
       {std::string("\x81\x01x"), client_frame(3, "x"), client_frame(kTextFrame, "\xFF"),
        "\x82\xFF" + std::string(8, '\x7F') + "mask",
        client_frame(kBinaryFrame, std::string(kLargestClientMessage + 1, 'x')), std::string(10000, '\0')}) {
    TestViewer viewer(server->port());
    viewer.open("");
    viewer.send_bytes(bad);
    EXPECT_NE(viewer.await_close().find("WebSocket"), std::string::npos);
  }
  EXPECT_TRUE(await([&] { return sessions == 0; }));
}

TEST_F(ServedPage, RefusesTheViewerThatIsOneTooMany) {
  start(2);
  TestViewer first(server->port()), second(server->port()), third(server->port());
  first.open("");
  second.open("");
  ASSERT_TRUE(await([&] { return sessions == 2; }));
  const std::string refused = third.open("");
  EXPECT_TRUE(refused.starts_with("HTTP/1.1 503 ")) << refused;
  first.close();
  ASSERT_TRUE(await([&] { return sessions == 1; }));
  EXPECT_TRUE(await([&] { return TestViewer(server->port()).open("").starts_with("HTTP/1.1 101 "); }));
}

TEST_F(ServedPage, SurvivesMalformedRequests) {
  start();
  for (const std::string& bytes :
       {std::string("\r\n\r\n"), std::string("GET\r\n\r\n"), std::string("\x16\x03\x01\x02\x00\x01\x00", 7),
        std::string("GET / HTTP/9.9\r\nHost: localhost\r\n\r\n"), std::string(100000, 'A'),
        "GET / HTTP/1.1\r\n" + std::string(50000, 'h') + ": x\r\n\r\n",
        "GET /?" + std::string(50000, 'q') + " HTTP/1.1\r\nHost: localhost\r\n\r\n",
        std::string("GET / HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\n\r\n"),
        std::string("GET / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 99999999999\r\n\r\n")}) {
    TestViewer hostile(server->port());
    hostile.send_bytes(bytes);
  }
  EXPECT_TRUE(get("/").starts_with("HTTP/1.1 200 "));
}

TEST_F(ServedPage, AnswersARequestThatIsNotHttpAsAnyOther) {
  start();
  for (const std::string method : {"", "\x16\x03\x01", "GET /"}) {
    const std::string response = get("/", "Host: localhost\r\n", method);
    EXPECT_TRUE(response.starts_with("HTTP/1.1 4") || response.starts_with("HTTP/1.1 5")) << response;
    EXPECT_NE(response.find("Content-Security-Policy"), std::string::npos) << response;
    EXPECT_EQ(response.find("Date:"), std::string::npos) << "civetweb's threads share the text of this header";
  }
}

TEST_F(ServedPage, EndsWithinASecondAlsoWithViewersThatDoNotRead) {
  start();
  TestViewer stalled(server->port(), 4096), half_open(server->port()), silent(server->port()), fine(server->port());
  stalled.open("");
  fine.open("");
  half_open.send_bytes("GET / HTTP/1.1\r\nHost: loc");
  ASSERT_TRUE(await([&] { return sessions == 2; }));
  // More than all buffers of the system take, so that the sender of this viewer blocks.
  const auto large = std::make_shared<const std::string>(std::size_t{7} << 20, 'x');
  {
    const std::lock_guard lock(mutex);
    for (int i = 0; i < 4; ++i) mailboxes[0]->add_data({WebSocketType::binary, {}, large}, Importance::image);
  }
  EXPECT_LT(stop(), 1.0);
  const std::string reason = fine.await_close();
  EXPECT_TRUE(reason == "the end" || reason.empty()) << reason;  // empty: its thread had no processor for that time
  EXPECT_EQ(sessions, 0);
}

TEST_F(ServedPage, DisconnectsAViewerThatAsksButNeverReads) {
  start();
  TestViewer flood(server->port(), 4096);
  flood.open("");
  const std::string frames = [] {
    std::string all;
    for (int i = 0; i < 1000; ++i) all += client_frame(kPingFrame, std::string(125, '?'));
    return all;
  }();
  ASSERT_TRUE(await(
      [&] {
        flood.send_bytes(frames);
        return sessions == 0;
      },
      std::chrono::milliseconds(0)));
}

TEST(WebServer, NamesThePortThatIsInUse) {
  const auto none = [](std::string_view) -> const ServedFile* { return nullptr; };
  const auto open = [](const auto&, const Access&) -> std::unique_ptr<ViewerSession> { return nullptr; };
  WebServer first({.port = 0, .token = kRightToken}, none, open);
  try {
    WebServer second({.port = first.port(), .token = kRightToken}, none, open);
    ADD_FAILURE() << "two servers at one port";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(std::to_string(first.port())), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("choose another"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace reorient::live

// SPDX-License-Identifier: MIT
// Who may watch, and who may change something.
#include "workbench/views/live/server/access.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "engine/parameters/utf8.h"

namespace reorient::live {
namespace {

const std::string kToken(32, 'a');

RequestHead viewer(const std::string& query = "", std::optional<std::string> origin = {}) {
  return {"GET", "/", query, "127.0.0.1:8765", std::move(origin), true, "foxglove.websocket.v1"};
}

AccessRules rules(const std::string& address = "127.0.0.1") { return {address, kToken, {"https://lab.example"}}; }

void expect_refused(const RequestHead& request, int code, const AccessRules& by = rules()) {
  const Access access = decide(request, by);
  EXPECT_EQ(access.refusal, code) << access.reason;
  EXPECT_FALSE(access.changes);
  EXPECT_FALSE(access.reason.empty());
  EXPECT_EQ(access.reason, as_line(access.reason));
}

void expect_watches(const RequestHead& request, const AccessRules& by = rules()) {
  const Access access = decide(request, by);
  EXPECT_EQ(access.refusal, 0) << access.reason;
  EXPECT_FALSE(access.changes);
  EXPECT_FALSE(access.why_not.empty());
  EXPECT_EQ(access.why_not, as_line(access.why_not));
}

void expect_changes(const RequestHead& request, const AccessRules& by = rules()) {
  const Access access = decide(request, by);
  EXPECT_EQ(access.refusal, 0) << access.reason;
  EXPECT_TRUE(access.changes) << access.why_not;
}

TEST(Access, KnowsItsOwnPage) {
  EXPECT_TRUE(is_own_page(viewer("", "http://127.0.0.1:8765")));
  EXPECT_FALSE(is_own_page(viewer("", "https://lab.example")));
  EXPECT_FALSE(is_own_page(viewer())) << "a program";
}

TEST(Access, NeedsTheHostOfTheServer) {
  for (const char* host : {"127.0.0.1", "127.0.0.1:8765", "localhost", "LOCALHOST:1", "[::1]", "[::1]:8765"}) {
    RequestHead request = viewer();
    request.host = host;
    expect_watches(request);
  }
  for (const char* host :
       {"", "evil.example", "evil.example:8765", "127.0.0.1.evil.example", "127.0.0.1@evil.example", "localhost.",
        "localhost:", "localhost:x", "localhost:123456", "[::1", "[]", "10.0.0.7", "evil\n\x1B[2J"}) {
    RequestHead request = viewer("token=" + kToken);
    request.host = host;
    expect_refused(request, 403);
    request.is_websocket = false;
    expect_refused(request, 403);
  }
}

TEST(Access, KnowsTheAddressThatTheUserChose) {
  RequestHead request = viewer("token=" + kToken);
  request.host = "10.0.0.7:8765";
  expect_changes(request, rules("10.0.0.7"));
  expect_changes(request, rules("0.0.0.0"));
  request.host = "[fe80::1]:8765";
  expect_refused(request, 403, rules("10.0.0.7"));
  expect_changes(request, rules("::"));
  request.host = "robot.example";
  expect_refused(request, 403, rules("0.0.0.0"));
}

TEST(Access, WithoutTheTokenOnlyWatches) {
  expect_watches(viewer());
  expect_watches(viewer("token=" + std::string(32, 'b')));
  expect_watches(viewer("token=" + kToken + "a"));
  expect_watches(viewer("token=" + kToken.substr(1)));
  expect_watches(viewer("token="));
  expect_watches(viewer("xtoken=" + kToken));
  expect_watches(viewer("token=" + std::string(100000, 'a')));
  expect_changes(viewer("token=" + kToken));
  expect_changes(viewer("a=1&token=" + kToken + "&b"));
}

TEST(Access, InANetworkNeedsTheTokenToWatch) {
  for (const char* address : {"10.0.0.7", "0.0.0.0", "::"}) {
    RequestHead request = viewer();
    request.host = "127.0.0.1";
    expect_refused(request, 403, rules(address));
    request.query = "token=" + std::string(32, 'b');
    expect_refused(request, 403, rules(address));
    request.query = "token=" + kToken;
    expect_changes(request, rules(address));
  }
}

TEST(Access, OfPagesOfOtherServersNeedsTheTokenToWatchAndAnOptionToChange) {
  for (const char* origin : {"http://evil.example", "https://127.0.0.1:8765", "http://127.0.0.1:8766", "null", "",
                             "http://127.0.0.1:8765.evil.example"}) {
    expect_refused(viewer("", origin), 403);
    expect_watches(viewer("token=" + kToken, origin));
  }
  expect_changes(viewer("token=" + kToken, "http://127.0.0.1:8765"));
  expect_watches(viewer("", "http://127.0.0.1:8765"));
  expect_refused(viewer("", "https://lab.example"), 403);
  expect_changes(viewer("token=" + kToken, "https://lab.example"));
  expect_watches(viewer("token=" + kToken, "https://lab.example.evil.example"));
}

TEST(Access, RefusesUnknownSubprotocolsPathsAndMethods) {
  RequestHead request = viewer("token=" + kToken);
  request.subprotocols = "chat, foxglove.websocket.v2";
  expect_refused(request, 400);
  const std::string reason = decide(request, rules()).reason;
  EXPECT_NE(reason.find("foxglove.websocket.v1"), std::string::npos);
  EXPECT_NE(reason.find("foxglove.sdk.v1"), std::string::npos);
  request = viewer("token=" + kToken);
  request.path = "/x";
  expect_refused(request, 404);
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "CONNECT", "get", ""}) {
    request = viewer("token=" + kToken);
    request.method = method;
    expect_refused(request, 405);
  }
}

TEST(Token, IsLongAndNeverTheSame) {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) tokens.insert(make_token());
  EXPECT_EQ(tokens.size(), 100u);
  for (const std::string& token : tokens) {
    EXPECT_EQ(token.size(), 32u);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
  }
}

}  // namespace
}  // namespace reorient::live

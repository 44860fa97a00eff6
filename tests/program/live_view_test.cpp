// SPDX-License-Identifier: MIT
// `run --live`, called as by a user, with viewers over real sockets.
#include "workbench/views/live/live_view.h"

#include <chrono>
#include <csignal>
#include <cstring>
#include <memory>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program/run/live/live_options.h"
#include "tests/program/child_program.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"
#include "tests/workbench/views/live/test_viewer.h"
#include "workbench/views/live/services.h"
#include "workbench/views/viewer/viewer_topics.h"

namespace reorient {
namespace {

using live::Service;
using live::TestViewer;
using LiveJson = nlohmann::json;

class LiveRunOfAUser : public ::testing::Test {
 protected:
  void start(const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"run", "patrol", "--live", "0", "--width", "160", "--no-pictures", "--log", "off"};
    words.insert(words.end(), more.begin(), more.end());
    run = std::make_unique<ChildProgram>(folder.path(), words);
    ASSERT_TRUE(run->await("live view: http")) << run->err();
    ASSERT_TRUE(run->await("?token="));
    const std::string err = run->err();
    std::smatch match;
    ASSERT_TRUE(std::regex_search(err, match, std::regex(R"(http://127\.0\.0\.1:(\d+)/\?token=([0-9a-f]{32})\n)")))
        << err;
    port = std::stoi(match[1]);
    token = match[2];
  }
  std::unique_ptr<TestViewer> connect(int buffer = 0) const {
    auto viewer = std::make_unique<TestViewer>(port, buffer);
    EXPECT_TRUE(viewer->open(token).starts_with("HTTP/1.1 101 "));
    return viewer;
  }
  static void subscribe_to_all(const TestViewer& viewer) {
    LiveJson all = LiveJson::array();
    for (int channel = 1; channel <= kViewerTopicCount; ++channel)
      all.push_back({{"id", channel}, {"channelId", channel}});
    viewer.send_json({{"op", "subscribe"}, {"subscriptions", all}});
  }
  static LiveJson call(TestViewer& viewer, Service service, const LiveJson& request) {
    viewer.call(live::id_of(service), 1, request.dump());
    return viewer.await_response(1);
  }
  std::string digest() const { return digest_of({0, run->out(), ""}); }

  TemporaryFolder folder;
  std::unique_ptr<ChildProgram> run;
  int port = 0;
  std::string token;
};

TEST_F(LiveRunOfAUser, ServesThePage) {
  start();
  const std::string page =
      TestViewer(port).request("/?token=" + token, "Host: localhost:" + std::to_string(port) + "\r\n");
  EXPECT_TRUE(page.starts_with("HTTP/1.1 200 ")) << page;
  EXPECT_NE(page.find("<title>Reorient"), std::string::npos);
}

TEST_F(LiveRunOfAUser, SendsAllTopicsThatASimulationHas) {
  start();
  const auto viewer = connect();
  subscribe_to_all(*viewer);
  std::vector<bool> seen(kViewerTopicCount + 1);
  const auto missing = [&] {
    std::string names;
    for (const ViewerTopicInfo& topic : kViewerTopics) {
      const std::string name(topic.name);
      const bool is_rare = name == "/log" || name == "/events" || name.starts_with("/camera/lower");
      if (!is_rare && !seen[live::channel_of(static_cast<std::size_t>(topic.topic))]) names += name + " ";
    }
    return names;
  };
  while (!missing().empty()) {
    const auto message = viewer->receive();
    ASSERT_TRUE(message) << missing();
    if (message->opcode == live::kBinaryFrame && message->data[0] == 1)
      seen[static_cast<unsigned char>(message->data[1])] = true;
  }
}

TEST_F(LiveRunOfAUser, ReplaysToTheSameDigestAlsoIfAViewerTunedIt) {
  const std::string file = (folder.path() / "run.mcap").string();
  start({"--seconds", "4", "--record", file});
  const auto viewer = connect();
  const LiveJson set =
      call(*viewer, Service::set_parameters, {{"parameters", {{{"name", "orientation.lingering"}, {"value", 0.4}}}}});
  EXPECT_EQ(set["parameters"][0]["value"], 0.4) << set;
  EXPECT_EQ(call(*viewer, Service::note, {{"text", "tuned"}}).count("time"), 1u);
  EXPECT_EQ(call(*viewer, Service::reload, {{"script", "orientation"}})["scripts"][0]["accepted"], true);
  EXPECT_EQ(call(*viewer, Service::undo, LiveJson::object())["parameters"].size(), 1u);
  EXPECT_EQ(viewer->await_close(), "the run has ended");
  run->wait();
  const ProgramRun replayed = run_reorient({"replay", file});
  EXPECT_EQ(replayed.code, 0) << replayed.out;
  EXPECT_EQ(digest_of(replayed), digest()) << run->out();
  EXPECT_NE(run->out().find("live view: 1 viewer; "), std::string::npos) << run->out();
}

TEST_F(LiveRunOfAUser, TriesChangesWithoutTouchingTheRun) {
  start({"--seconds", "10"});
  const auto viewer = connect();
  const LiveJson change{{"parameters", {{{"name", "head_scan.timeout"}, {"value", 0.5}}}}};
  LiveJson answer;
  std::uint32_t number = 10;
  const auto ask = [&](const LiveJson& request) {
    viewer->call(live::id_of(Service::what_if), ++number, request.dump());
    return viewer->await_response(number);
  };
  // Until the head has turned back sooner than it did.
  do {
    answer = ask(change);
    ASSERT_FALSE(answer.is_null()) << "the run has ended";
  } while (answer.value("first_decision", LiveJson()).is_null());
  EXPECT_NE(answer["first_decision"]["text"].get<std::string>().find("head_scan"), std::string::npos);
  EXPECT_EQ(answer["first_decision"]["tried"], true);
  EXPECT_EQ(answer["time"].size(), answer["frames"].get<std::size_t>());
  EXPECT_EQ(answer["tried"]["evidence"].size(), answer["time"].size());
  EXPECT_NE(ask({{"parameters", {{{"name", "no.such"}, {"value", 1}}}}}).value("message", "").find("no.such"),
            std::string::npos);
  EXPECT_NE(ask({{"scripts", {{{"file", "behaviors/head_scan.lua"}, {"text", "broken("}}}}})
                .value("message", "")
                .find("head_scan.lua:1"),
            std::string::npos);
  run->wait();
  const ProgramRun alone =
      run_reorient({"run", "patrol", "--width", "160", "--no-pictures", "--seconds", "10", "--log", "off"});
  EXPECT_EQ(digest(), digest_of(alone)) << "nothing of it reaches the run";
}

TEST_F(LiveRunOfAUser, KeepsNoFramesWithoutMemory) {
  start({"--seconds", "2", "--live-memory", "0"});
  const auto viewer = connect();
  EXPECT_NE(call(*viewer, Service::what_if, {{"parameters", {{{"name", "a"}, {"value", 1}}}}})
                .value("message", "")
                .find("keeps no frames"),
            std::string::npos);
}

TEST_F(LiveRunOfAUser, HasTheDigestOfARunWithoutViewers) {
  start({"--seconds", "3"});
  const auto viewer = connect();
  subscribe_to_all(*viewer);
  viewer->await_close();
  run->wait();
  const ProgramRun alone =
      run_reorient({"run", "patrol", "--width", "160", "--seconds", "3", "--no-pictures", "--log", "off"});
  EXPECT_EQ(digest(), digest_of(alone));
}

TEST_F(LiveRunOfAUser, EndsInTimeAlsoWithViewersThatDoNotRead) {
  start({"--seconds", "3"});
  std::vector<std::unique_ptr<TestViewer>> stalled;
  for (int i = 0; i < 3; ++i) subscribe_to_all(*stalled.emplace_back(connect(4096)));
  TestViewer half_open(port);
  half_open.send_bytes("GET / HT");
  EXPECT_TRUE(run->await("digest: "));
  EXPECT_LE(run->wait(), 1);
  EXPECT_NE(run->out().find("in 91 frames"), std::string::npos) << run->out();
}

TEST_F(LiveRunOfAUser, EndsAtASignalWithinASecondOfItsLastFrame) {
  start();
  const auto viewer = connect();
  subscribe_to_all(*viewer);
  ASSERT_TRUE(viewer->receive());
  run->kill(SIGTERM);
  viewer->await_close();
  EXPECT_EQ(run->wait(), 128 + SIGTERM);
}

TEST_F(LiveRunOfAUser, RefusesWhatAnotherPageWouldTry) {
  start();
  TestViewer rebound(port), foreign(port), watching(port), guessing(port);
  EXPECT_TRUE(rebound.open(token, "foxglove.websocket.v1", "", "evil.example").starts_with("HTTP/1.1 403 "));
  EXPECT_TRUE(
      foreign.open("", "foxglove.websocket.v1", "Origin: http://evil.example\r\n").starts_with("HTTP/1.1 403 "));
  const auto refusal = [](TestViewer& viewer) {
    return call(viewer, Service::note, {{"text", "x"}}).value("message", "");
  };
  EXPECT_TRUE(
      watching.open(token, "foxglove.websocket.v1", "Origin: http://evil.example\r\n").starts_with("HTTP/1.1 101 "));
  EXPECT_NE(refusal(watching).find("--live-allow-origin"), std::string::npos);
  EXPECT_TRUE(guessing.open(std::string(32, '0')).starts_with("HTTP/1.1 101 "));
  EXPECT_NE(refusal(guessing).find("token"), std::string::npos);
}

TEST_F(LiveRunOfAUser, LetsANamedPageChangeThings) {
  start({"--live-allow-origin", "https://lab.example"});
  TestViewer page(port);
  page.open(token, "foxglove.sdk.v1", "Origin: https://lab.example\r\n");
  EXPECT_EQ(call(page, Service::note, {{"text", "x"}}).count("time"), 1u);
}

TEST(LiveOptions, AreCheckedBeforeTheRun) {
  const auto expect_refused = [](const std::vector<std::string>& words, const std::string& text) {
    std::vector<std::string> all{"run"};
    all.insert(all.end(), words.begin(), words.end());
    const ProgramRun refused = run_reorient(all);
    EXPECT_EQ(refused.code, 2) << words.back();
    EXPECT_NE(refused.err.find(text), std::string::npos) << refused.err;
  };
  expect_refused({"--live", "patrol"}, "expected a port");
  expect_refused({"--live", "65536"}, "expected a port");
  expect_refused({"--live", "-1"}, "");
  expect_refused({"--live-address", "127.0.0.1"}, "--live");
  expect_refused({"--live", "0", "--live-address", "robot.local"}, "expected an IPv4 address");
  expect_refused({"--live", "0", "--live-address", "::1"}, "expected an IPv4 address");
  expect_refused({"--live", "0", "--live-allow-origin", "lab.example/x"}, "expected an origin");
  expect_refused({"--live", "0", "--view-images", "png"}, "--view-images");
  expect_refused({"--live", "0", "--live-address", "203.0.113.1"}, "cannot listen");
}

TEST(LiveOptions, OfANaoShowHalfOfTheFramesWithoutImages) {
  LiveOptions options;
  EXPECT_EQ(live_view_options(options, LiveLoad::light).every, 2);
  EXPECT_EQ(live_view_options(options, LiveLoad::light).jpeg_quality, 0);
  EXPECT_EQ(live_view_options(options, LiveLoad::usual).every, 1);
  EXPECT_EQ(live_view_options(options, LiveLoad::usual).jpeg_quality, 75);
  options.images = "jpeg:50";
  EXPECT_EQ(live_view_options(options, LiveLoad::light).jpeg_quality, 50);
}

}  // namespace
}  // namespace reorient

// SPDX-License-Identifier: MIT
// `replay FILE --live`: a recording in real time, controlled by the time bar of a viewer.
#include <bit>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/child_program.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"
#include "tests/workbench/views/live/test_viewer.h"
#include "workbench/views/live/protocol/foxglove_protocol.h"
#include "workbench/views/live/services.h"
#include "workbench/views/viewer/viewer_topics.h"

namespace reorient {
namespace {

using live::PlaybackStatus;
using live::Received;
using live::TestViewer;

template <typename Number>
Number number_at(const std::string& bytes, std::size_t place) {
  Number number{};
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

class ReplayForViewers : public ::testing::Test {
 protected:
  void start(const std::vector<std::string>& more = {}) {
    const std::string file = (folder.path() / "run.mcap").string();
    ASSERT_LE(run_shortly({"--record", file}).code, 1);
    std::vector<std::string> words{"replay", file, "--live", "0"};
    words.insert(words.end(), more.begin(), more.end());
    program = std::make_unique<ChildProgram>(folder.path(), words);
    ASSERT_TRUE(program->await("?token=")) << program->err();
    const std::string err = program->err();
    std::smatch match;
    ASSERT_TRUE(std::regex_search(err, match, std::regex(R"(127\.0\.0\.1:(\d+)/\?token=([0-9a-f]{32}))"))) << err;
    viewer = std::make_unique<TestViewer>(std::stoi(match[1]));
    ASSERT_TRUE(viewer->open(match[2]).starts_with("HTTP/1.1 101 "));
    info = viewer->receive()->json();
    const auto channel = live::channel_of(static_cast<std::size_t>(ViewerTopic::pose));
    viewer->send_json({{"op", "subscribe"}, {"subscriptions", {{{"id", 1}, {"channelId", channel}}}}});
  }
  void control(bool pauses, float speed, std::optional<double> seek, const std::string& id) const {
    std::string bytes("\x03", 1);
    bytes += pauses ? '\x01' : '\0';
    const auto append = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
    append(speed);
    bytes += seek ? '\x01' : '\0';
    append(live::to_nanoseconds(seek.value_or(0.0)));
    append(static_cast<std::uint32_t>(id.size()));
    viewer->send_bytes(live::client_frame(live::kBinaryFrame, bytes + id));
  }
  /// The next state of the playback for which this holds; poses until then are stored.
  std::string await_state(const std::function<bool(PlaybackStatus, const std::string& id)>& is_it) {
    const auto found = viewer->await([&](const Received& one) {
      if (one.opcode != live::kBinaryFrame) return false;
      if (one.data[0] == 1) poses[number_at<std::uint64_t>(one.data, 5)].push_back(one.data.substr(13));
      constexpr std::size_t kId = 19;
      return one.data[0] == 5 && is_it(static_cast<PlaybackStatus>(one.data[1]), one.data.substr(kId));
    });
    return found ? found->data : std::string(kShortest, '\0');
  }
  static constexpr std::size_t kShortest = 19;

  TemporaryFolder folder;
  std::unique_ptr<ChildProgram> program;
  std::unique_ptr<TestViewer> viewer;
  nlohmann::json info;
  std::map<std::uint64_t, std::vector<std::string>> poses;  // by time, ns
};

TEST_F(ReplayForViewers, PlaysHoldsSeeksAndRepeatsTheSameFrames) {
  start();
  const auto& capabilities = info["capabilities"];
  EXPECT_NE(std::find(capabilities.begin(), capabilities.end(), "playbackControl"), capabilities.end()) << info;
  EXPECT_EQ(info["dataStartTime"]["sec"], 0);
  EXPECT_EQ(info["dataEndTime"]["sec"], 3);
  control(false, 2.0f, {}, "fast");
  await_state([](PlaybackStatus status, const std::string&) { return status == PlaybackStatus::ended; });
  const auto first = poses;
  EXPECT_GT(first.size(), 20u);

  control(true, 1.0f, 1.0, "back");
  const std::string paused = await_state([](PlaybackStatus, const std::string& id) { return id == "back"; });
  EXPECT_EQ(paused[1], static_cast<char>(PlaybackStatus::paused));
  EXPECT_NEAR(1e-9 * static_cast<double>(number_at<std::uint64_t>(paused, 2)), 1.0, 0.1);
  EXPECT_EQ(paused[14], 1) << "did seek";

  control(false, 2.0f, 0.0, "again");
  await_state([](PlaybackStatus, const std::string& id) { return id == "again"; });
  await_state([](PlaybackStatus status, const std::string&) { return status == PlaybackStatus::ended; });
  int repeated = 0;
  for (const auto& [time, all] : poses) {
    for (const std::string& pose : all) {
      EXPECT_EQ(pose, all.front()) << 1e-9 * static_cast<double>(time) << " s";
      repeated += &pose != &all.front() ? 1 : 0;
    }
  }
  EXPECT_GT(repeated, 20) << "the same frames, played twice";
  EXPECT_FALSE(program->has_ended()) << "it holds at the end";
  program->kill(SIGINT);
  EXPECT_EQ(program->wait(), 128 + SIGINT) << program->err();
  EXPECT_NE(program->out().find("live view: 1 viewer"), std::string::npos) << program->out();
}

TEST_F(ReplayForViewers, SurvivesHostileControls) {
  start({"--from", "1"});
  for (const double target : {0.0, 1e9, 18e9}) control(false, 1e30f, target, "far");
  viewer->send_bytes(live::client_frame(live::kBinaryFrame, "\x03"));
  control(false, 0.0f, {}, std::string(1000, '\n'));
  control(false, 20.0f, 1.5, "sound");
  await_state([](PlaybackStatus, const std::string& id) { return id == "sound"; });
  await_state([](PlaybackStatus status, const std::string&) { return status == PlaybackStatus::ended; });
  EXPECT_FALSE(program->has_ended());
}

TEST_F(ReplayForViewers, AnswersWhileItIsPaused) {
  start();
  control(true, 1.0f, {}, "pause");
  await_state([](PlaybackStatus, const std::string& id) { return id == "pause"; });
  viewer->send_json({{"op", "getParameters"}, {"parameterNames", {"orientation.lingering"}}, {"id", "x"}});
  EXPECT_EQ(viewer->await_operation("parameterValues")["parameters"].size(), 1u);
  viewer->call(live::id_of(live::Service::note), 1, R"({"text":"x"})");
  EXPECT_NE(viewer->await_response(1).value("message", "").find("paused"), std::string::npos);
  viewer->call(live::id_of(live::Service::machine), 2, R"({"machine":"orientation"})");
  EXPECT_EQ(viewer->await_response(2)["machine"]["name"], "orientation");
}

}  // namespace
}  // namespace reorient

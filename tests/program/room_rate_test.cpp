// SPDX-License-Identifier: MIT
// `reorient room rate`, called as by a user.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program/model/model_file.h"
#include "tests/perception/room/saved_models.h"
#include "tests/program/program_run.h"
#include "tests/shared_data.h"
#include "tests/temporary_folder.h"
#include "workbench/files/input_file.h"
#include "workbench/views/pictures/rating_view.h"

namespace reorient {
namespace {

using test::some_model;
using Words = std::vector<std::string>;

class RoomRate : public ::testing::Test {
 protected:
  static ProgramRun rate(Words words) {
    words.insert(words.begin(), {"room", "rate"});
    words.insert(words.end(), {"--trials", "8", "--log", "off"});
    return run_reorient(words);
  }
  std::string path(const std::string& name) const { return (folder.path() / name).string(); }
  std::string file_of(const SavedModel& model, const std::string& name = "a.model") const {
    write_model_file(model, folder.path() / name);
    return path(name);
  }
  /// One line, and nothing else.
  static void expect_refused(const Words& words, const std::string& complaint) {
    const ProgramRun refused = rate(words);
    EXPECT_EQ(refused.code, kBadInput) << refused.out;
    EXPECT_EQ(refused.out, "");
    EXPECT_NE(refused.err.find(complaint), std::string::npos) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
  static nlohmann::json read_json(const std::string& file) { return nlohmann::json::parse(std::ifstream(file)); }

  TemporaryFolder folder;
};

/// Width and height of a PNG file, which follow its signature and the head of its first chunk.
std::pair<int, int> size_of_png(const std::string& file) {
  const std::string bytes = read_input(file, "a file");
  if (bytes.size() < 24 || bytes.substr(1, 3) != "PNG") return {0, 0};
  const auto number = [&](std::size_t place) {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = 256 * value + static_cast<unsigned char>(bytes[place + i]);
    return value;
  };
  return {number(16), number(20)};
}

TEST_F(RoomRate, RatesTheBuiltInHallAndWritesPictureAndNumbers) {
  const ProgramRun run = rate({"hall", "--learn", "30", "--picture", path("ring.png"), "--json", path("hall.json")});
  ASSERT_EQ(run.code, kSuccess) << run.err << run.out;
  for (const char* const line : {"verdict: works\n", "time to correction of a mirrored belief: mean ",
                                 "false flips: ", "  best:\n", "  worst:\n", "what would help: ", "picture: "})
    EXPECT_NE(run.out.find(line), std::string::npos) << line << run.out;
  EXPECT_EQ(size_of_png(path("ring.png")), (std::pair{pictures::kRatingWidth, pictures::kRatingHeight}));
  const auto json = read_json(path("hall.json"));
  EXPECT_EQ(json["verdict"], "works");
  EXPECT_EQ(json["works"], true);
  EXPECT_EQ(json["times"]["trials"], 8);
  EXPECT_GT(json["times"]["mean_s"], 1.0);
  EXPECT_LT(json["times"]["mean_s"], 5.0);
  EXPECT_EQ(json["directions"].size(), 48u);
}

TEST_F(RoomRate, CallsTheSymmetricVersionOfTheHallSymmetric) {
  const ProgramRun run =
      rate({"hall", "--set", "room_shape.symmetry=two_fold", "--banner", "0", "--json", path("twin.json")});
  EXPECT_EQ(run.code, kWrong) << run.err << run.out;
  EXPECT_NE(run.out.find("verdict: does not work: the room looks the same rotated by 180 degrees"), std::string::npos)
      << run.out;
  const auto json = read_json(path("twin.json"));
  EXPECT_EQ(json["verdict"], "symmetric");
  EXPECT_TRUE(json["times"].is_null());
}

TEST_F(RoomRate, CallsAQuarterOfAWallTooLittle) {
  const ProgramRun run = rate({file_of(some_model(1, 0, 0.1, 0, 12))});
  EXPECT_EQ(run.code, kWrong) << run.err;
  EXPECT_NE(run.out.find("verdict: does not work: too little was learned, 25 % of the wall (expected at least 30 %)\n"),
            std::string::npos)
      << run.out;
  EXPECT_NE(run.out.find("what would help: let the robot learn more"), std::string::npos) << run.out;
}

TEST_F(RoomRate, WritesTheFieldsThatAreDocumented) {
  ASSERT_EQ(rate({file_of(some_model(1)), "--json", path("a.json")}).code, kSuccess);
  const auto json = read_json(path("a.json"));
  const auto has_all = [](const nlohmann::json& object, const Words& names) {
    for (const std::string& name : names) EXPECT_TRUE(object.contains(name)) << name;
    EXPECT_EQ(object.size(), names.size()) << object.dump();
  };
  has_all(json, {"room", "verdict", "works", "reason", "learned_s", "misfit", "coverage", "distinctiveness",
                 "separability", "times", "false_flips", "directions", "banner"});
  has_all(json["times"], {"trials", "evaluated", "corrected", "limit_s", "mean_s", "p90_s", "mean_up_to_limit_s"});
  has_all(json["false_flips"], {"per_hour", "trials", "flips", "seconds", "mean_evidence", "evidence_deviation"});
  has_all(json["directions"][0], {"azimuth_degrees", "log_odds", "deviation", "known", "words"});
  has_all(json["banner"],
          {"width_m", "height_m", "foot_m", "color_bin", "color", "best_azimuth_degrees", "without", "with", "places"});
  has_all(json["banner"]["places"][0], {"azimuth_degrees", "usable", "times"});
  EXPECT_EQ(json["banner"]["places"].size(), 24u);
}

TEST_F(RoomRate, RatesTheModelAtTheEndOfARecording) {
  const std::string model = path("run.model"), recording = path("run.mcap");
  ASSERT_EQ(run_reorient({"run", "trial", "--set", "trial.event=none", "--set", "trial.learn=30", "--seconds", "25",
                          "--width", "160", "--no-pictures", "--log", "off", "--model", model, "--record", recording})
                .code,
            kWrong)
      << "the scenario has no verdict yet";
  const ProgramRun of_model = rate({model, "--banner", "0", "--json", path("model.json")});
  const ProgramRun of_recording = rate({recording, "--banner", "0", "--json", path("recording.json")});
  EXPECT_EQ(of_recording.code, of_model.code) << of_recording.err;
  auto one = read_json(path("model.json")), other = read_json(path("recording.json"));
  EXPECT_EQ(other["room"], "recording " + recording + ", at its end");
  one.erase("room");
  other.erase("room");
  EXPECT_EQ(one, other) << "both contain the model at the end of the run";
}

TEST_F(RoomRate, RefusesATruncatedRecording) {
  const std::string recording = path("run.mcap");
  run_shortly({"--record", recording});
  const std::string bytes = read_input(recording, "a file");
  ASSERT_GT(bytes.size(), 10'000u);
  for (const std::size_t size : {bytes.size() - 1, bytes.size() / 2, std::size_t{64}, std::size_t{9}}) {
    SCOPED_TRACE(size);
    expect_refused({folder.write("cut.mcap", std::string_view(bytes).substr(0, size)).string()}, "cut.mcap: ");
  }
}

TEST_F(RoomRate, RefusesEachDamagedModel) {
  for (const test::DamagedModel& damaged : test::damaged_models()) {
    SCOPED_TRACE(damaged.what);
    const std::string file =
        folder.write("b.model", {reinterpret_cast<const char*>(damaged.bytes.data()), damaged.bytes.size()}).string();
    expect_refused({file}, damaged.complaint);
  }
}

TEST_F(RoomRate, RefusesFilesThatAreNotRooms) {
  expect_refused({path("no.model")}, "no.model: expected a model of a room, found none");
  expect_refused({path("no.hdr")}, "unknown room '" + path("no.hdr") + "'");
  expect_refused({path("no.mcap")}, "no.mcap: expected a model of a room, found none; name a panorama");
  expect_refused({folder.path().string()}, "expected a model of a room, found a folder; name a panorama");
  expect_refused({folder.write("a.txt", "hello\n").string()},
                 "a.txt: it is not a model of a room; name a panorama (.hdr, .png, .jpg)");
  expect_refused({folder.write("a.hdr", "hello\n").string()}, "a.hdr");
  expect_refused({folder.write("a.png", "hello\n").string()}, "a.png");
  expect_refused({folder.write("empty.hdr", "").string()}, "empty.hdr");
  expect_refused({file_of(some_model(1, 0, 0.1, 0, 0))}, "expected a model with learned tiles, found an empty one");
  expect_refused({""}, "room");
}

TEST_F(RoomRate, RefusesInvalidOptions) {
  const std::string model = file_of(some_model(1));
  expect_refused({model, "--set", "room_shape.simmetry=two_fold"}, "room_shape.simmetry");
  expect_refused({model, "--set", "decision.false_flips=often"}, "decision.false_flips");
  expect_refused({model, "--misfit", "nan"}, "--misfit");
  expect_refused({model, "--banner", "-1"}, "--banner");
  expect_refused({model, "--learn", "0"}, "--learn");
  expect_refused({model, "--json", model}, "--json");
  expect_refused({model, "--json", path("x"), "--picture", path("x")}, "--json");
  expect_refused({model, "--picture", path("no/where/x.png")}, "--picture");
  const ProgramRun alone = run_reorient({"room"});
  EXPECT_EQ(alone.code, kBadInput);
  EXPECT_NE(alone.err.find("rate"), std::string::npos) << alone.err;
}

class RoomRateOfRealRooms : public SharedDataTest {
 protected:
  RoomRateOfRealRooms() : SharedDataTest("rooms") {}
};

TEST_F(RoomRateOfRealRooms, RatesAPanoramaAndCallsItsSymmetricVersionSymmetric) {
  const std::string room = (folder() / "st_fagans_interior.hdr").string();
  const Words words{"room", "rate", room, "--trials", "8", "--banner", "0", "--log", "off"};
  const ProgramRun told = run_reorient(words);
  EXPECT_EQ(told.code, kSuccess) << told.err << told.out;
  Words twin = words;
  twin.insert(twin.end(), {"--set", "room_shape.symmetry=two_fold"});
  EXPECT_EQ(run_reorient(twin).code, kWrong);
}

}  // namespace
}  // namespace reorient

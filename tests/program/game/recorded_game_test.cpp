// SPDX-License-Identifier: MIT
// `game --record`, called as by a user.
#include "tests/program/game/recorded_game.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace reorient {
namespace {

/// The digest that a game printed for the recording of a robot; empty without one.
std::string printed_digest(const ProgramRun& game, const std::string& robot) {
  const std::size_t line = game.out.find("/" + robot + ".mcap, ");
  const std::size_t place = game.out.find(", digest ", line);
  return line == std::string::npos || place == std::string::npos ? "" : game.out.substr(place + 9, 16);
}

TEST_F(GameThatIsRecorded, HasTheDigestOfOneThatIsNotAndEachRobotThatOfItsReplay) {
  const ProgramRun plain = run_reorient(words({"--threads", "1"}));
  ASSERT_EQ(plain.code, 0) << plain.err;
  for (const char* const threads : {"1", "2"}) {
    const ProgramRun recorded = record({"--threads", threads});
    EXPECT_EQ(recorded.code, 0) << recorded.err;
    EXPECT_EQ(recorded.err, "");
    EXPECT_EQ(digest_of(recorded), digest_of(plain)) << threads;
    for (const std::string& robot : kBothTeams) {
      const ProgramRun replayed = run_reorient({"replay", recording_of(robot)});
      EXPECT_EQ(replayed.code, 0) << replayed.out << replayed.err;
      EXPECT_NE(replayed.out.find("60 frames, up to "), std::string::npos) << replayed.out;
      EXPECT_NE(replayed.out.find("all frames are the same as recorded"), std::string::npos) << replayed.out;
      EXPECT_EQ(digest_of(replayed), "digest: " + printed_digest(recorded, robot)) << robot;
    }
  }
}

TEST_F(GameThatIsRecorded, CanBeReadLikeARun) {
  record();
  const ProgramRun info = run_reorient({"recording", "info", recording_of("red_2")});
  EXPECT_EQ(info.code, 0) << info.err;
  EXPECT_NE(info.out.find("player: red 2"), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("scenario: game"), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("60 can be replayed exactly"), std::string::npos) << info.out;
  const ProgramRun table = run_reorient({"recording", "export", recording_of("red_2"), "--csv", "world"});
  EXPECT_EQ(table.code, 0) << table.err;
  const ProgramRun events = run_reorient({"replay", recording_of("blue_1"), "--events"});
  EXPECT_NE(events.out.find("approach_ball: "), std::string::npos) << events.out;
  const ProgramRun what_if = run_reorient({"replay", recording_of("blue_1"), "--set", "search_ball.speed=0.2"});
  EXPECT_EQ(what_if.code, 0) << what_if.err;
  const ProgramRun pictures =
      run_reorient({"recording", "pictures", recording_of("blue_1"), "--at", "1", "--out", path("pictures")});
  EXPECT_EQ(pictures.code, 0) << pictures.err;
}

TEST_F(GameThatIsRecorded, ReplacesItsOwnRecordingsAndNothingElse) {
  record();
  record({"--record-images", "none"}, "1");
  const ProgramRun info = run_reorient({"recording", "info", recording_of("blue_1")});
  EXPECT_NE(info.out.find("30 frames"), std::string::npos) << info.out;

  const ProgramRun smaller = record({}, "2", "1");
  EXPECT_EQ(smaller.code, kBadInput);
  EXPECT_NE(smaller.err.find("--record " + path("game") +
                             ": expected no recording of a robot that does not play, "
                             "found "),
            std::string::npos)
      << smaller.err;
  std::filesystem::remove(recording_of("red_2"));
  folder_.write("game/red_2.mcap", "a letter");
  const ProgramRun run = record();
  EXPECT_EQ(run.code, kBadInput);
  EXPECT_NE(run.err.find("red_2.mcap: expected a new file or a recording, found another file"), std::string::npos)
      << run.err;
  EXPECT_EQ(std::filesystem::file_size(recording_of("red_2")), 8u);
}

TEST_F(GameThatIsRecorded, StartsNewFilesAsARunDoes) {
  const ProgramRun parts = record({"--record-rotate", "1s"});
  EXPECT_EQ(parts.code, 0) << parts.err;
  EXPECT_NE(parts.out.find("blue_1.mcap and 1 more, 60 frames"), std::string::npos) << parts.out;
  EXPECT_EQ(run_reorient({"replay", path("game/red_1.2.mcap")}).code, 0);
  const ProgramRun again = record({"--record-rotate", "1s"});
  EXPECT_EQ(again.code, kBadInput);
  EXPECT_NE(again.err.find("blue_1.2.mcap: expected no part of an earlier run, found one"), std::string::npos)
      << again.err;
}

TEST_F(GameThatIsRecorded, RefusesInvalidOptionsWithOneLine) {
  const std::string text = folder_.write("text", "no folder").string();
  const std::pair<std::vector<std::string>, const char*> mistakes[] = {
      {{"--record", text}, "--record"},
      {{"--record", ""}, "--record"},
      {{"--record", "/proc/nowhere"}, "--record"},
      {{"--record", path("game"), "--record-images", "some"}, "--record-images: expected lossless, every:N"},
      {{"--record", path("game"), "--record-rotate", "often"}, "--record-rotate: expected a size or a time"},
      {{"--record", path("game"), "--view-particles", "every:"}, "--view-particles: expected every:N"},
      {{"--view-images", "png"}, "--view-images: expected jpeg:Q"},
  };
  for (const auto& [more, why] : mistakes) {
    const ProgramRun run = run_reorient(words(more));
    EXPECT_EQ(run.code, kBadInput) << why;
    EXPECT_NE(run.err.find(why), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
}

}  // namespace
}  // namespace reorient

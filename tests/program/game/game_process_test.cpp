// SPDX-License-Identifier: MIT
// `game --record` as a separate process: a full disk, an interruption, missing permissions.
#include <csignal>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/program/child_program.h"
#include "tests/program/game/recorded_game.h"
#include "tests/program/less_of_a_user.h"

namespace reorient {
namespace {

class GameProcess : public GameThatIsRecorded {};

TEST_F(GameProcess, EndsItsRecordingsWithoutDamageIfTheDiskIsFullAndContinues) {
  const ProgramRun plain = run_reorient(words({}));
  ChildProgram run(folder_.path(), words({"--record", path("game")}), files_up_to(500'000));
  EXPECT_EQ(run.wait(), 0) << run.err();
  for (const std::string& robot : kBothTeams) {
    EXPECT_NE(
        run.err().find("reorient: the recording ends here: " + recording_of(robot) + ": the file cannot be written: "),
        std::string::npos)
        << run.err();
    const ProgramRun replayed = run_reorient({"replay", recording_of(robot)});
    EXPECT_EQ(replayed.code, 0) << replayed.out;
    EXPECT_EQ(replayed.err, "") << "the recording is complete";
  }
  EXPECT_NE(run.out().find(digest_of(plain)), std::string::npos) << run.out();
}

TEST_F(GameProcess, EndsAllRecordingsWhenItIsInterrupted) {
  ChildProgram run(folder_.path(), words({"--record", path("game")}, "3600"));
  ASSERT_TRUE(run.await("playing"));
  run.kill(SIGINT);
  EXPECT_EQ(run.wait(), 128 + SIGINT) << run.err();
  for (const std::string& robot : kBothTeams) {
    const ProgramRun replayed = run_reorient({"replay", recording_of(robot)});
    EXPECT_EQ(replayed.code, 0) << replayed.out << replayed.err;
  }
}

TEST_F(GameProcess, RefusesAFolderInWhichItMayNotWrite) {
  std::filesystem::permissions(folder_.path(), std::filesystem::perms::all);
  std::filesystem::create_directory(path("game"));
  ChildProgram run(folder_.path(), words({"--record", path("game")}), become_an_ordinary_user);
  const int code = run.wait();
  if (code == kCannot) GTEST_SKIP() << "this user cannot drop its permissions";
  EXPECT_EQ(code, kBadInput);
  EXPECT_NE(run.err().find("--record"), std::string::npos) << run.err();
  EXPECT_TRUE(std::filesystem::is_empty(path("game")));
}

}  // namespace
}  // namespace reorient

// SPDX-License-Identifier: MIT
// Applications as teams write them: values and actions of a client in Python, and of a program that embeds the engine.
#include <cstdio>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/paths.h"
#include "tests/program/child_program.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

const std::string kTree = kSourceFolder;

std::string output_of(const std::string& command, int& code) {
  std::string text;
  FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return "popen failed";
  for (int letter = fgetc(pipe); letter != EOF; letter = fgetc(pipe)) text += static_cast<char>(letter);
  code = pclose(pipe);
  return text;
}

TEST(ApplicationOfAClient, IsServedByAShippedBehaviorAndReplayed) {
  const TemporaryFolder folder;
  const std::string socket = (folder.path() / "s").string(), recording = (folder.path() / "run.mcap").string();
  {
    ChildProgram companion(folder.path(), {"run", "--robot", "companion", "--socket", socket, "--behaviors",
                                           "kick_ball", "--record", recording});
    ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
    int code = 0;
    const std::string said = output_of(
        "python3 " + kTree + "/examples/companion/ball.py " + socket + " " + kTree + "/assets/interfaces/ball.toml",
        code);
    EXPECT_EQ(code, 0) << said << companion.err();
    EXPECT_EQ(said, "kick 1 with the left foot\nkick 2 with the right foot\nkick 3 with the left foot\n");
    companion.kill(SIGTERM);
    companion.wait();
    EXPECT_NE(companion.out().find("action kick"), std::string::npos) << companion.out();
  }
  ChildProgram replay(folder.path(), {"replay", recording});
  EXPECT_EQ(replay.wait(), 0) << replay.out() << replay.err();
  EXPECT_NE(replay.out().find("all frames are the same as recorded"), std::string::npos) << replay.out();
  ChildProgram table(folder.path(), {"recording", "export", recording, "--csv", "world"});
  EXPECT_EQ(table.wait(), 0) << table.err();
  EXPECT_NE(table.out().find("input.ball.position.x"), std::string::npos);
  EXPECT_NE(table.out().find(",running,"), std::string::npos);
}

TEST(ApplicationOfAClient, WithAMistakeInItsInterfaceIsRefusedWithTheLine) {
  const TemporaryFolder folder;
  const std::string socket = (folder.path() / "s").string(), file = (folder.path() / "wrong.toml").string();
  std::ofstream(file) << "[values.ball]\ntype = \"nummer\"\ndescription = \"x\"\n";
  ChildProgram companion(folder.path(),
                         {"run", "--robot", "companion", "--socket", socket, "--behaviors", "kick_ball"});
  ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
  int code = 0;
  const std::string said = output_of("python3 " + kTree + "/examples/companion/ball.py " + socket + " " + file, code);
  EXPECT_NE(code, 0);
  EXPECT_NE(said.find("refused: hello: interface: wrong:2: type: expected number"), std::string::npos) << said;
}

TEST(DetectorOfAClient, LocatesTheRobotAndIsReplayed) {
  const TemporaryFolder folder;
  const std::string socket = (folder.path() / "s").string(), recording = (folder.path() / "run.mcap").string();
  {
    ChildProgram companion(folder.path(), {"run", "--robot", "companion", "--socket", socket, "--behaviors",
                                           "orientation", "--record", recording});
    ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
    int code = 0;
    const std::string said = output_of("python3 " + kTree + "/examples/companion/detector.py " + socket, code);
    EXPECT_EQ(code, 0) << said << companion.err();
    EXPECT_EQ(said, "pose: -2.0 m, 1.0 m, 0.3 rad\n");
    companion.kill(SIGTERM);
    companion.wait();
  }
  ChildProgram replay(folder.path(), {"replay", recording});
  EXPECT_EQ(replay.wait(), 0) << replay.out() << replay.err();
  EXPECT_NE(replay.out().find("all frames are the same as recorded"), std::string::npos) << replay.out();
}

TEST(ApplicationThatEmbedsTheEngine, RunsAShippedBehavior) {
  int code = 0;
  const std::string said = output_of(std::string(kApplicationExample) + " " + kTree + "/scripts", code);
  EXPECT_EQ(code, 0) << said;
  EXPECT_EQ(said.substr(said.find("s: ")), "s: direction = 0, foot = \"left\"\n" + said.substr(said.find('\n') + 1));
}

}  // namespace
}  // namespace reorient

// SPDX-License-Identifier: MIT
// The guard and the program as processes, in real time: messages about missing inputs, and the end of the processes.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/angle.h"
#include "tests/paths.h"
#include "tests/program/child_program.h"
#include "tests/temporary_folder.h"
#include "tests/waiting.h"
#include "workbench/files/calibration_file.h"

namespace reorient {
namespace {

class NaoProcesses : public ::testing::Test {
 protected:
  std::string file(const char* name) const { return (folder_.path() / name).string(); }

  TemporaryFolder folder_;
};

TEST_F(NaoProcesses, RefuseOptionsThatANaoDoesNotUseWithOneLine) {
  const std::pair<std::vector<std::string>, const char*> mistakes[] = {
      {{"run", "mirrored_placement", "--robot", "nao"}, "--robot nao: expected no scenario"},
      {{"run", "--robot", "nao", "--room", "hall.hdr"}, "--room: expected --robot simulator, found --robot nao"},
      {{"run", "--robot", "nao", "--socket", "/tmp/s"}, "--socket: expected --robot companion, found --robot nao"},
      {{"run", "--robot", "nao", "--width", "160"}, "--width: expected 320 or 640 pixels for a NAO, found 160"},
      {{"run", "--robot", "nao", "--at", "1,2"}, "expected X,Y,DEGREES"},
      {{"run", "--robot", "nao", "--at", "1,2,3,4"}, "expected X,Y,DEGREES"},
      {{"run", "--robot", "nao", "--at", "nan,0,0"}, "expected X,Y,DEGREES"},
      {{"run", "--robot", "nao", "--at", "1e308,0,0"}, "m (-100 to 100)"},
      {{"run", "--robot", "nao", "--at", "0,101,0"}, "m (-100 to 100)"},
      {{"run", "--robot", "nao", "--places", folder_.write("far.toml", "player_1 = [200, 2, 3]").string(), "--team",
        "5"},
       "player_1: expected a pose within 100 m"},
      {{"run", "--robot", "nao", "--team", "255"}, "--team"},
      {{"run", "--robot", "nao", "--guard", folder_.write("other", "x").string()}, "of another version of the guard"},
      {{"run", "--robot", "nao", "--places", folder_.write("places.toml", "player_1 = [1, 2, 3]").string()},
       "--places: expected --team"},
      {{"run", "--robot", "nao", "--at", "30,2,0"},
       "--at 30,2,0: expected a position on the carpet (x from -5.2 to 5.2 m, y from -3.7 to 3.7 m), found one beside "
       "it"},
      {{"run", "--robot", "nao", "--at", "0,-3.8,0"}, "--at 0,-3.8,0: expected a position on the carpet"},
      {{"run", "--robot", "nao", "--places", folder_.write("places.toml", "player_1 = [1, 2, 3]").string(), "--team",
        "5", "--player", "7"},
       "--player 7: expected a player with a pose in "},
      {{"run", "--robot", "nao", "--places", folder_.write("bad.toml", "player_0 = [1, 2, 3]").string(), "--team", "5"},
       "unknown key 'player_0'"},
      {{"run", "--robot", "nao", "--calibration", file("nowhere.toml")}, "expected a file (calibration), found none"},
      {{"run", "--robot", "nao", "--calibration",
        folder_.write("late.toml", "[footage]\nrecorded_roll = false").string()},
       "ignores values recorded in footage"},
      {{"calibrate"}, "expected --at ("},
      {{"calibrate", "--at", "here"}, "expected X,Y,DEGREES"},
      {{"calibrate", "--at", "0,0,0", "--out", "/nowhere/calibration.toml"}, "--out"},
      {{"calibrate", "--at", "0,0,0", "--width", "160"}, "--width"},
      {{"run", "--team", "5"}, "--team: expected --robot nao, found --robot simulator"},
      {{"run", "--stand"}, "--stand: expected --robot nao, found --robot simulator"},
  };
  for (const auto& [words, why] : mistakes) {
    ChildProgram program(folder_.path(), words);
    EXPECT_EQ(program.wait(), 2) << why;
    EXPECT_NE(program.err().find(why), std::string::npos) << program.err();
  }
}

TEST_F(NaoProcesses, TheCamerasOfASimulatedRobotAreCalibrated) {
  ChildProgram program(
      folder_.path(), {"calibrate", "--robot", "simulator", "--at", "-3.6,-1.2,20", "--width", "320", "--set",
                       "simulator.tilt_offset=0.03", "--set", "body.attitude_bias=0", "--set", "simulator.tilt_error=0",
                       "--out", file("calibration.toml"), "--pictures", file("out")});
  ASSERT_EQ(program.wait(), 0) << program.out() << program.err();
  const Calibration calibration = load_calibration(file("calibration.toml"));
  for (const CameraOffset& offset : calibration.offsets) {
    EXPECT_NEAR(to_degrees(offset.tilt), to_degrees(0.03), 0.15);
    EXPECT_NEAR(offset.pan, 0.0, from_degrees(0.4));
  }
  for (const char* const picture : {"calibration_upper_before.png", "calibration_lower_after.png"})
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / picture)) << picture;
}

TEST_F(NaoProcesses, TheProgramReportsAMissingGuardAndWaitsForIt) {
  ChildProgram program(folder_.path(), {"run", "--robot", "nao", "--guard", file("body")});
  EXPECT_TRUE(program.await("no guard is running; start reorient-nao-guard")) << program.err();
  program.kill(SIGTERM);
  EXPECT_EQ(program.wait(), 128 + SIGTERM);
  EXPECT_NE(program.out().find("0 frames"), std::string::npos) << program.out();
}

TEST_F(NaoProcesses, TheGuardRefusesInvalidOptions) {
  const std::pair<const char*, const char*> mistakes[] = {
      {"--priority 100", "--priority: expected a number from 0 to 99"},
      {"--priority", "--priority: expected a value"},
      {"--stand", "--stand: unknown option"},
      {"--body /", "reorient-nao-guard: /"},
      {"--body /dev/null", "expected a guard's file of this user"},
  };
  for (const auto& [words, why] : mistakes) {
    const std::string err = file("err");
    const int status = std::system((std::string(kGuard) + " " + words + " 2>" + err).c_str());
    EXPECT_EQ(WEXITSTATUS(status), 2) << words;
    const std::string said = read_text(err);
    EXPECT_NE(said.find(why), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  }
}

/// SIGHUP is sent if the login from which the guard was started is lost.
TEST_F(NaoProcesses, TheGuardConnectsToTheRobotAndEndsOnASignal) {
  const std::string lola = file("lola"), body = file("body"), said = file("said");
  const std::string limit = std::to_string(kWaitLimit.count()), tries = std::to_string(10 * kWaitLimit.count());
  const auto ended_by = [&](const std::string& signal) {
    return std::string(kLolaTwin) + " " + lola + " " + file("status") + " " + limit +
           " </dev/null >/dev/null 2>&1 & twin=$!; " + kGuard + " --lola " + lola + " --body " + body +
           " --priority 0 2>" + said + " & guard=$!; for i in $(seq " + tries + "); do grep -q connected " + said +
           " && break; sleep 0.1; done; kill -" + signal + " $guard; wait $guard; code=$?; kill $twin; exit $code";
  };
  for (const char* const signal : {"TERM", "HUP"}) {
    SCOPED_TRACE(signal);
    std::filesystem::remove(said);  // do not read the output of the previous guard
    EXPECT_EQ(std::system(ended_by(signal).c_str()), 0) << read_text(said);
    EXPECT_NE(read_text(said).find("connected to LoLA"), std::string::npos) << read_text(said);
    EXPECT_FALSE(std::filesystem::exists(body)) << "it removes its shared memory";
  }
}

/// The whole job takes as long as on a robot: nao_real_time_job GUARD. Here it ends as soon as the robot stands.
TEST_F(NaoProcesses, WorkWithTheSimulatedLolaAndV4l2InRealTime) {
  const std::string command = std::string(kRealTimeJob) + " " + kGuard + " 1 320 " +
                              std::to_string(kWaitLimit.count()) + " >" + file("out") + " 2>" + file("err");
  EXPECT_EQ(std::system(command.c_str()), 0) << read_text(file("out")) << read_text(file("err"));
}

}  // namespace
}  // namespace reorient

// SPDX-License-Identifier: MIT
// The operator and the pace of a run, at the prompt.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "program/run/console/live_console.h"
#include "tests/paths.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"
#include "tests/workbench/run/hand_fed_robot.h"

namespace reorient {
namespace {

/// The times of frames are left out, because they are sums of rounded steps.
std::string without_times(std::string text) {
  for (std::size_t at = text.find(" at 0."); at != std::string::npos; at = text.find(" at 0.")) text.erase(at, 10);
  return text;
}

class OperatorAtThePrompt : public ::testing::Test {
 protected:
  /// The output of a run in which the user types these lines, and then `quit`.
  std::string session(const std::string& lines, bool has_operator = true, bool sets_pace = true) {
    run.emplace(has_operator, sets_pace);
    int ends[2] = {-1, -1};
    if (pipe(ends) != 0) ADD_FAILURE() << "no pipe";
    const std::string typed = lines + "quit\n";
    EXPECT_EQ(write(ends[1], typed.data(), typed.size()), static_cast<ssize_t>(typed.size()));
    close(ends[1]);
    std::ostringstream out;
    LiveConsole console(ends[0], out,
                        {.parameters = [this] { return run->loop.engine->parameters(); },
                         .engine = [this] { return &*run->loop.engine; },
                         .controls = &run->controls});
    RunParts parts = run->parts({&console}, {&console});
    parts.stop = [&] { return console.wants_to_quit(); };
    RunLoop(std::move(parts)).run();
    close(ends[0]);
    return without_times(out.str());
  }
  using Texts = std::vector<std::string>;

  /// Of a parameter of the engine.
  std::size_t index_of(const std::string& name) const {
    const std::vector<Parameter> all = run->loop.engine->parameters();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Parameter& one) { return one.name == name; });
    EXPECT_NE(found, all.end());
    return static_cast<std::size_t>(found - all.begin());
  }

  std::optional<HandFedRun> run;
};

TEST_F(OperatorAtThePrompt, ActsOnTheRobot) {
  EXPECT_EQ(session("pick_up\nput_down 1 -2 90\npush_over\npenalize\npenalize off\nchange_light\n"
                    "set_exposure_compensation -1.5\n"),
            "  pick_up\n  put_down at x 1.00 m, y -2.00 m, 90.0 degrees\n  push_over\n  penalize on\n  penalize off\n"
            "  change_light\n  set_exposure_compensation -1.50 stops\n");
  EXPECT_EQ(run->robot->done, (Texts{"pick_up", "put_down", "push_over", "penalize", "end the penalty", "change_light",
                                     "light -1.500000"}));
  expect_near(run->robot->pose, Pose2(1.0, -2.0, 0.5 * kPi), 1e-9);
}

TEST_F(OperatorAtThePrompt, MirrorsTheRobot) {
  EXPECT_EQ(session("mirror\n"), "  mirror\n");
  expect_near(run->robot->pose, reflect(Pose2(-3.0, 1.0, 0.5)), 1e-9);
}

TEST_F(OperatorAtThePrompt, RefusesHostileValues) {
  for (const char* bad : {"nan", "inf", "1e308", "-101", "1,5", "", "x", "0x10"}) {
    const std::string text = session("put_down " + std::string(bad) + " 0 0\nset_initial_pose 0 " + bad + " 0\n");
    EXPECT_EQ(run->robot->done, Texts()) << bad;
    EXPECT_EQ(text.find("put_down at"), std::string::npos) << text;
    EXPECT_NE(text.find("expected"), std::string::npos) << text;
  }
  EXPECT_NE(session("penalize maybe\n").find("penalize: expected on or off, found 'maybe'"), std::string::npos);
  EXPECT_NE(session("set_exposure_compensation 9\n").find("-8 to 8 stops"), std::string::npos);
  EXPECT_NE(session("speed 0\n").find("0.05 to 20"), std::string::npos);
  EXPECT_NE(session("speed nan\n").find("0.05 to 20"), std::string::npos);
  EXPECT_NE(session("frame 0\n").find("1 to 1000"), std::string::npos);
  EXPECT_NE(session("frame 1.5\n").find("1 to 1000"), std::string::npos);
  EXPECT_EQ(session("mirror now\n"), "  expected mirror\n");
}

TEST_F(OperatorAtThePrompt, IsMissingOnOtherRobotsExceptForTheInitialPose) {
  for (const char* command :
       {"pick_up", "put_down 0 0 0", "mirror", "push_over", "penalize", "change_light", "set_exposure_compensation 1"})
    EXPECT_NE(session(std::string(command) + "\n", false).find("expected a robot that this program can lift and place"),
              std::string::npos)
        << command;
  EXPECT_EQ(session("set_initial_pose 1 2 3\n", false), "  set_initial_pose at x 1.00 m, y 2.00 m, 3.0 degrees\n");
  for (const char* command : {"pause", "resume", "frame", "speed 2"})
    EXPECT_NE(session(std::string(command) + "\n", true, false).find("found a robot that sets its own pace"),
              std::string::npos)
        << command;
}

TEST_F(OperatorAtThePrompt, AnswersQuestionsWhileTheRunIsPaused) {
  const std::string text =
      session("pause\nparams field_features.pixel_deviation\nstates\nworld clock.time\nhelp frame\n");
  EXPECT_NE(text.find("  paused\n  field_features.pixel_deviation = "), std::string::npos) << text;
  EXPECT_NE(text.find("tested"), std::string::npos) << text;
  EXPECT_NE(text.find("clock.time = 0.000 s"), std::string::npos) << text;
  EXPECT_NE(text.find("frame [N]"), std::string::npos) << text;
}

TEST_F(OperatorAtThePrompt, ChangesAPausedRunWithTheNextFrame) {
  const std::string text =
      session("pause\nset field_features.pixel_deviation 3\npick_up\nwait 1\nframe 2\nresume\nspeed 4\n");
  const std::string later = "  the run is paused; this takes effect with the next frame\n";
  EXPECT_EQ(text, "  paused\n" + later + later +
                      "  wait: expected a run that is not paused; resume it first\n"
                      "  field_features.pixel_deviation = 3\n  pick_up\n  paused\n"
                      "  1 times real time\n  4 times real time\n");
  EXPECT_EQ(run->robot->done, (Texts{"pick_up"}));
}

TEST_F(OperatorAtThePrompt, UndoesTheChangeThatWasRequestedLastInAPausedRun) {
  const std::string name = "field_features.pixel_deviation", set = "set " + name + " ";
  const std::string later = "  the run is paused; this takes effect with the next frame\n";
  const auto value_after = [&](const std::string& lines) {
    session("pause\n" + lines + "frame 1\nresume\n");
    return to_text(run->loop.engine->parameters()[index_of(name)].value);
  };
  session("");
  const std::string standard = to_text(run->loop.engine->parameters()[index_of(name)].value);
  EXPECT_EQ(value_after(set + "3\nundo\n"), standard);
  EXPECT_EQ(value_after(set + "3\n" + set + "4\nundo\n"), "3");
  EXPECT_EQ(value_after(set + "3\n" + set + "4\nundo\nundo\n"), standard);
  EXPECT_EQ(value_after(set + "3\n" + set + "-1\n" + set + "4\nundo\n"), "3") << "-1 is refused";
  EXPECT_EQ(value_after(set + "3\nundo\nundo\n"), standard);
  const std::string text = session("pause\n" + set + "3\n" + set + "-1\nundo\nundo\nundo\nframe 1\nresume\nundo\n");
  EXPECT_NE(text.find(later + later + later + later + "  no change to undo\n  " + name + " = 3\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("0 to 20 pixels)\n  " + name + " = 3\n  " + name + " = " + standard + "\n"), std::string::npos)
      << text;
  EXPECT_TRUE(text.ends_with("times real time\n  no change to undo\n")) << text;
}

TEST_F(OperatorAtThePrompt, AlignsTheHelpOfAllCommands) {
  std::istringstream lines(session("help\n"));
  constexpr std::size_t kColumn = 24;
  int commands = 0;
  for (std::string line; std::getline(lines, line); ++commands) {
    EXPECT_LE(line.size(), 100u) << line;
    if (line.size() <= kColumn || line.starts_with("  set_exposure_compensation ") ||
        line.starts_with("  set_initial_pose "))
      continue;
    EXPECT_NE(line[kColumn], ' ') << line;
    EXPECT_EQ(line.substr(kColumn - 2, 2), "  ") << line;
  }
  EXPECT_GT(commands, 20);
}

TEST(OperatorInARun, IsRecordedAndReplayed) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "run.mcap").string(), out = (folder.path() / "out.txt").string();
  const std::string commands =
      "speed 20\\nwait 1\\nset_initial_pose 1 2 30\\nmirror\\nwait 1\\npause\\npush_over\\nframe 3\\nchange_light\\n"
      "resume\\nwait 1\\npenalize\\nquit\\n";
  const std::string line = "printf '" + commands + "' | REORIENT_HOME=" + kSourceFolder + " " + kProgram +
                           " run patrol --realtime --width 160 --no-pictures --log off --record " + file + " >" + out +
                           " 2>/dev/null";
  ASSERT_EQ(std::system(line.c_str()), 0);
  std::ifstream in(out);
  const std::string printed((std::istreambuf_iterator<char>(in)), {});
  for (const char* action :
       {"set_initial_pose at x 1.00 m, y 2.00 m, 30.0 degrees", "mirror", "push_over", "change_light"})
    EXPECT_NE(printed.find(std::string("operator              note: ") + action), std::string::npos) << action << "\n"
                                                                                                     << printed;
  const ProgramRun replayed = run_reorient({"replay", file});
  EXPECT_EQ(replayed.code, 0) << replayed.err;
  EXPECT_EQ(digest_of(replayed), digest_of({0, printed, ""}));
  EXPECT_NE(replayed.out.find("all frames are the same as recorded"), std::string::npos) << replayed.out;
}

TEST(OperatorInARun, DoesNotDelayTheEndOfAPausedRun) {
  const std::string line = std::string("printf 'pause\\nquit\\n' | REORIENT_HOME=") + kSourceFolder + " " + kProgram +
                           " run patrol --realtime --width 160 --no-pictures --log off >/dev/null 2>&1";
  EXPECT_EQ(std::system(line.c_str()), 0);
}

}  // namespace
}  // namespace reorient

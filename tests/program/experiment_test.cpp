// SPDX-License-Identifier: MIT
// `reorient experiment`, as a user, a shell and a cluster call it.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/random.h"
#include "program/experiment/session.h"
#include "tests/paths.h"
#include "tests/program/child_program.h"
#include "tests/program/short_experiment.h"
#include "workbench/files/input_file.h"

namespace reorient {
namespace {

std::string backwards(const std::string& text) {
  std::istringstream in(text);
  std::string all;
  for (std::string line; std::getline(in, line);) all.insert(0, line + "\n");
  return all;
}

using ExperimentTest = ShortExperiment;

TEST_F(ExperimentTest, PrintsARowForEachCell) {
  const ProgramRun done = run({"--out", path("out")});
  EXPECT_EQ(done.code, kSuccess) << done.err;
  EXPECT_TRUE(done.out.starts_with("Who is right?\n")) << done.out;
  for (const char* text : {"\nmode ", "\ndefault ", "\nnone "})
    EXPECT_NE(done.out.find(text), std::string::npos) << done.out;
}

TEST_F(ExperimentTest, WritesTheSameJsonFromOneAndFromSeveralProcesses) {
  const std::string alone = table("one");
  EXPECT_NE(alone.find("\"mode\": \"none\",\n    \"trials\": 2"), std::string::npos) << alone;
  EXPECT_EQ(table("two", {"--jobs", "2"}), alone);

  const ProgramRun plan = run({"--plan", "--out", path("lines")});
  EXPECT_EQ(plan.code, kSuccess) << plan.err;
  EXPECT_EQ(std::count(plan.out.begin(), plan.out.end(), '\n'), 4);
  // As GNU parallel or a Slurm array would: each line by itself, in any order.
  const std::string script = std::string("set -e\nexport REORIENT_HOME='") + kSourceFolder + "'\nreorient() { '" +
                             kProgram + "' --log off \"$@\"; }\n";
  const std::filesystem::path shell = folder.write("lines.sh", script + backwards(plan.out));
  ASSERT_EQ(std::system(("sh " + shell.string()).c_str()), 0);
  EXPECT_EQ(table("lines", {"--resume"}), alone);
}

TEST_F(ExperimentTest, RunsNoTaskTwice) {
  const std::string all = table("out");
  const std::filesystem::path second = folder.path() / "out/tasks/000002.json";
  const auto written = std::filesystem::last_write_time(second);
  std::filesystem::remove(folder.path() / "out/tasks/000003.json");
  EXPECT_EQ(table("out", {"--resume"}), all);
  EXPECT_EQ(run({"--out", path("out"), "--task", "2"}).code, kSuccess);
  EXPECT_EQ(std::filesystem::last_write_time(second), written);
}

TEST_F(ExperimentTest, DoesNotMixTwoRuns) {
  table("out", {"--trials", "1"});
  expect_refused({"--out", path("out"), "--trials", "1"},
                 "contains 2 of 2 results already; --resume prints them, another --out starts again");
  expect_refused({"--out", path("out"), "--trials", "1", "--seed", "9", "--resume"},
                 "expected the result of this trial, found that of another: seed (1 instead of 9);");
  expect_refused({"--out", path("out"), "--trials", "1", "--set", "orientation.lingering=0.3", "--resume"},
                 "expected the result of this trial, found that of another: orientation.lingering (none instead of "
                 "0.3);");
  folder.write("out/tasks/000001.json", "{\"task\": 1");
  expect_refused({"--out", path("out"), "--trials", "1", "--resume"},
                 "000001.json: expected the result of a task, found other or damaged content");
}

TEST_F(ExperimentTest, HasAFolderForEachPlan) {
  struct Plan {
    std::uint64_t seed = 1;
    std::vector<std::string> rooms{}, only{}, set{};
  };
  const auto folder_of = [&](const Plan& plan) {
    SessionOptions options;
    options.experiment = file.string();
    options.seed = plan.seed;
    options.rooms = plan.rooms;
    options.only = plan.only;
    options.parameters.assignments = plan.set;
    return Session(options).folder().string();
  };
  EXPECT_EQ(folder_of({}), "out/experiments/short");
  std::set<std::string> folders{folder_of({})};
  const Plan plans[] = {{.seed = 9},
                        {.rooms = {"hall"}},
                        {.only = {"mode=default"}},
                        {.only = {"mode=none"}},
                        {.only = {"mode=default", "mode=none"}},
                        {.set = {"orientation.lingering=0.3"}},
                        {.set = {"orientation.lingering=0.4"}}};
  for (const Plan& plan : plans) {
    const std::string name = folder_of(plan);
    EXPECT_TRUE(name.starts_with("out/experiments/short-")) << name;
    EXPECT_TRUE(folders.insert(name).second) << name;
    EXPECT_EQ(folder_of(plan), name) << "--resume finds it";
  }
}

TEST_F(ExperimentTest, RefusesAnAxisWithoutEffect) {
  const std::string axis =
      "[[axis]]\nname = \"width\"\n[[axis.choice]]\nname = \"narrow\"\n"
      "without = [\"head_scan\"]\nparameters.head_scan.width = 0.5\n"
      "[[axis.choice]]\nname = \"usual\"\n";
  folder.write("short.toml", kShort + axis + "without = [\"head_scan\"]\n");
  expect_refused({"--out", path("out")},
                 "short.toml:22: expected a parameter of a script that a cell of the "
                 "experiment loads, found 'head_scan.width'");
  // Another cell loads it.
  folder.write("short.toml", kShort + axis);
  const ProgramRun plan = run({"--out", path("out"), "--plan"});
  EXPECT_EQ(plan.code, kSuccess) << plan.err;
}

TEST_F(ExperimentTest, MeasuresWhatTheFileNames) {
  folder.write("short.toml", kShort +
                                 "[measure]\nmean = [\"robot.head_yaw\"]\nmaximum = [\"robot.head_yaw\"]\n"
                                 "entered = [\"head_scan/walls to the left\"]\n");
  const ProgramRun printed = run({"--out", path("out"), "--json", path("rows.json")});
  EXPECT_EQ(printed.code, kSuccess) << printed.err;
  EXPECT_NE(printed.out.find("maximum robot.head_yaw"), std::string::npos) << printed.out;
  const std::string rows = read_input(path("rows.json"), "rows");
  EXPECT_NE(rows.find("\"measures\": {\"entered head_scan/walls to the left\":{\"unit\":\"\",\"trials\":"),
            std::string::npos)
      << rows;
  EXPECT_NE(rows.find("\"mean robot.head_yaw\":{\"unit\":\"rad\",\"trials\":"), std::string::npos) << rows;
}

TEST_F(ExperimentTest, RefusesMeasuresOfUnknownStatesAndActions) {
  const auto expect_mistake = [&](const std::string& measure, const std::string& mistake) {
    folder.write("short.toml", kShort + "[measure]\n" + measure + "\n");
    expect_refused({"--out", path("out")}, mistake);
  };
  expect_mistake("entered = [\"head_scan/walls to the lef\"]",
                 "measure.entered: unknown state 'head_scan/walls to the lef' (did you mean 'head_scan/walls to the "
                 "left'?)");
  expect_mistake("transitions = [\"other/a > b\"]", "measure.transitions: unknown state 'other/a'");
  expect_mistake("granted = [\"action.kick\"]", "measure.granted: unknown action 'kick'");
}

TEST_F(ExperimentTest, DoesNotSetAParameterThatAnAxisSets) {
  folder.write("short.toml", kShort + "parameters.orientation.lingering = 0.5\n");
  expect_refused({"--out", path("out"), "--set", "orientation.lingering=0.3"},
                 "--set: expected a parameter that no axis sets, found 'orientation.lingering', which axis 'mode' sets "
                 "at " +
                     path("short.toml") + ":17; choose its value with --only mode=CHOICE");
  const std::string tuned = folder.write("tuned.toml", "\norientation.lingering = 0.3\n").string();
  expect_refused({"--out", path("out"), "--params", tuned}, tuned + ":2: expected a parameter that no axis sets");
  EXPECT_EQ(run({"--out", path("out"), "--set", "orientation.lingering=0.3", "--only", "mode=default", "--plan"}).code,
            kSuccess);
}

TEST_F(ExperimentTest, RunsPartOfItsTasks) {
  EXPECT_EQ(run({"--out", path("out"), "--tasks", "2-3"}).code, kSuccess);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/tasks/000003.json"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/tasks/000001.json"));
  expect_refused({"--out", path("out"), "--task", "5"}, "unknown task 5 (expected 1 to 4)");
  expect_refused({"--out", path("out"), "--tasks", "1-"},
                 "expected a list of tasks, as in 17, 1-64 or 1-64,70, found '1-'");
}

TEST_F(ExperimentTest, RefusesInvalidOptionsBeforeItRunsAnything) {
  const std::string out = path("out");
  folder.write("short.toml", std::string(kShort) + "widht = 160\n");
  expect_refused({"--out", out}, "short.toml:17: unknown key 'widht' (did you mean 'width'?)");
  folder.write("short.toml", std::string(kShort) + "room = \"gone.hdr\"\n");
  expect_refused({"--out", out}, "gone.hdr");
  folder.write("short.toml", std::string(kShort) + "scenario = \"mirrored_placemnt\"\n");
  expect_refused({"--out", out}, "did you mean 'mirrored_placement'?");
  folder.write("short.toml", kShort);
  expect_refused({"--out", out, "--room", "gone.hdr"}, "gone.hdr");
  expect_refused({"--out", out, "--trials", "0"}, "--trials");
  expect_refused({"--out", out, "--jobs", "0"}, "--jobs");
  EXPECT_FALSE(std::filesystem::exists(out));
  const ProgramRun unknown = run_reorient({"experiment", "mirrored_placemnt"});
  EXPECT_EQ(unknown.code, kBadInput);
  EXPECT_NE(unknown.err.find("did you mean 'mirrored_placement'?"), std::string::npos) << unknown.err;
}

TEST_F(ExperimentTest, RunsTheRequestedChoices) {
  const std::string one = table("one", {"--mode", "none", "--trials", "1"});
  EXPECT_EQ(one.find("\"default\""), std::string::npos) << one;
  EXPECT_NE(one.find("\"mode\": \"none\""), std::string::npos) << one;
  EXPECT_EQ(table("only", {"--only", "mode=none", "--trials", "1"}), one);
  const std::filesystem::path mine = folder.write("eager.toml", "parameters.orientation.lingering = 0.1\n");
  const std::string own = table("own", {"--mode", "none", "--mode", mine.string(), "--trials", "1"});
  EXPECT_NE(own.find("\"mode\": \"eager\""), std::string::npos) << own;
  expect_refused({"--mode", "nnoe"}, "axis mode: unknown choice 'nnoe' (did you mean 'none'?)");
  expect_refused({"--light", "hard"}, "unknown axis 'light'");
  expect_refused({"--only", "mode"}, "--only: expected AXIS=CHOICE, found 'mode'");
  folder.write("eager.toml", "parameters.orientation.lingring = 0.1\nlimti = 3\n");
  expect_refused({"--mode", mine.string()}, "eager.toml:2: unknown key 'limti'");
}

TEST_F(ExperimentTest, RunsTheGivenRoomsInsteadOfTheFilesRooms) {
  const std::string halls = table("out", {"--rooms", "hall", "--mode", "none", "--trials", "1"});
  EXPECT_NE(halls.find("\"room\": \"hall\""), std::string::npos) << halls;
  expect_refused({"--rooms", "hall", "hall"}, "--rooms: expected different rooms, found hall twice");
}

TEST_F(ExperimentTest, ShowsATrialAloneWithPictures) {
  const ProgramRun shown = run({"--trial", "3", "--pictures", path("pictures")});
  EXPECT_EQ(shown.code, kSuccess) << shown.err;
  for (const char* text :
       {"mode none, trial 1 (seed 1)\n", "right: the belief was right at first", "mirrored_placement"})
    EXPECT_NE(shown.out.find(text), std::string::npos) << shown.out;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "pictures/confidences.png"));
  expect_refused({"--trial", "5"}, "unknown trial 5 (expected 1 to 4)");
  expect_refused({"--pictures", path("pictures")}, "--trial");
}

TEST_F(ExperimentTest, ShowsATrialAloneWithARoomLearnedOnAnotherDay) {
  folder.write("short.toml", R"(title = "Who remembers?"
trials = 1
[condition]
scenario = "trial"
learned_before = 20.0
width = 160
seconds = 20
parameters.trial.learn = 0.0
parameters.trial.event = "misled"
measured_from = "measured"
limit = 6.0
hold = 3.0
)");
  const ProgramRun shown = run({"--trial", "1"});
  EXPECT_EQ(shown.code, kSuccess) << shown.err;
  EXPECT_NE(shown.out.find("corrected by a command after: 0."), std::string::npos) << shown.out;
}

TEST_F(ExperimentTest, ReportsTrialsThatWereNeverMeasured) {
  std::string text = kShort;
  const std::string from = "measured_from = \"learning\"";
  folder.write("short.toml", text.replace(text.find(from), from.size(), "measured_from = \"mirrored\""));
  const ProgramRun done = run({"--out", path("out"), "--trials", "1", "--mode", "none"});
  EXPECT_EQ(done.code, kSuccess) << done.err;
  EXPECT_NE(done.out.find("\nnone: 1 of 1 trials never reached the state from which they are measured, and count as "
                          "failed: perhaps 'seconds' is too short\n"),
            std::string::npos)
      << done.out;
  EXPECT_EQ(run({"--out", path("x"), "--trials", "1", "--mode", "none", "--plan"}).out.find("never came"),
            std::string::npos);
}

TEST_F(ExperimentTest, StopsAtAMistakeThatAppearsInATrial) {
  const std::string room = folder.write("room.png", "no picture").string();
  folder.write("short.toml", std::string(kShort) + "room = \"" + room + "\"\n");
  expect_refused({"--out", path("out")}, "task 3, mode none, trial 1 (seed 1): ");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/tasks/000002.json")) << "finished trials are stored";
}

TEST_F(ExperimentTest, ReportsAFullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const ProgramRun done = run({"--out", path("out"), "--trials", "1", "--json", "/dev/full"});
  EXPECT_EQ(done.code, kBadInput);
  EXPECT_NE(done.err.find("/dev/full"), std::string::npos) << done.err;
}

/// REORIENT_INTERRUPTIONS=100 sets the number of interruptions.
TEST_F(ExperimentTest, GoesOnWhereItWasKilled) {
  const char* const wanted = std::getenv("REORIENT_INTERRUPTIONS");
  const int count = wanted == nullptr ? 3 : std::atoi(wanted);
  const std::string all = table("whole");
  Random random(1);
  for (int i = 0; i < count; ++i) {
    const std::string out = "killed" + std::to_string(i);
    {
      ChildProgram program(folder.path(), words({"--out", path(out), "--jobs", "2"}));
      let_time_pass(random.uniform(0.0, 2.0));
      program.kill(i % 3 == 0 ? SIGINT : SIGKILL);
      const int code = program.wait();
      EXPECT_TRUE(code == 0 || code == 130 || code == -SIGKILL || code == -SIGINT) << code << program.err();
    }
    EXPECT_EQ(table(out, {"--resume"}), all) << out;
  }
}

}  // namespace
}  // namespace reorient

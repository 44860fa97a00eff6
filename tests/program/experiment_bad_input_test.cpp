// SPDX-License-Identifier: MIT
// Invalid experiments are refused in one line before anything is run or written.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/program/short_experiment.h"

namespace reorient {
namespace {

struct InvalidExperiment {
  const char* name;
  std::string text;
  std::vector<std::string> words;
  const char* error;
};

std::string with_line(const std::string& line) { return std::string(kShort) + line + "\n"; }

/// `axes` axes of ten choices each.
std::string many_cells(int axes) {
  std::string text = "title = \"x\"\n[condition]\nscenario = \"mirrored_placement\"\n";
  for (int axis = 0; axis < axes; ++axis) {
    text += "[[axis]]\nname = \"" + std::to_string(axis) + "\"\n";
    for (int choice = 0; choice < 10; ++choice) text += "[[axis.choice]]\nname = \"" + std::to_string(choice) + "\"\n";
  }
  return text;
}

std::string axis_named(const std::string& name) {
  return with_line("[[axis]]\nname = \"" + name + "\"\n[[axis.choice]]\nname = \"a\"");
}

class InvalidExperimentTest : public ShortExperiment, public ::testing::WithParamInterface<InvalidExperiment> {};

TEST_P(InvalidExperimentTest, IsRefusedInOneLineAndLeavesNothing) {
  folder.write("short.toml", GetParam().text);
  std::vector<std::string> all = GetParam().words;
  all.insert(all.end(), {"--out", path("out")});
  expect_refused(all, GetParam().error);
  EXPECT_FALSE(std::filesystem::exists(path("out")));
}

using InvalidParameters = ShortExperiment;

TEST_F(InvalidParameters, AreReportedAtTheLineThatSetsThem) {
  folder.write("short.toml", with_line("parameters.orientation.lingering = 7"));
  const ProgramRun refused = run({"--out", path("out")});
  EXPECT_TRUE(refused.err.starts_with("reorient: " + path("short.toml") + ":17: parameter orientation.lingering: "))
      << refused.err;
}

INSTANTIATE_TEST_SUITE_P(
    Files, InvalidExperimentTest,
    ::testing::Values(
        InvalidExperiment{"MisspelledKey",
                          with_line("scenari = \"fallen\""),
                          {},
                          "short.toml:17: unknown key 'scenari' (did you mean 'scenario'?)"},
        InvalidExperiment{
            "ImpossibleValue", with_line("limit = -1"), {}, ":17: limit: expected a number from 0 to 86400, found -1"},
        InvalidExperiment{"WrongType",
                          with_line("seconds = \"long\""),
                          {},
                          ":17: seconds: expected a number from 1 to 86400, found 'long'"},
        InvalidExperiment{"TooManyTrials", "trials = 99999999999999999999\n", {}, "short.toml:1: "},
        InvalidExperiment{"Letters", "\xFF\xFE\x01 = 3", {}, "short.toml:1: "},
        InvalidExperiment{"EmptyFile", "", {}, "title: expected one sentence"},
        InvalidExperiment{"AxisTwice", axis_named("mode"), {}, "axis: expected different names, found 'mode' twice"},
        InvalidExperiment{"ChoiceTwice",
                          with_line("[[axis.choice]]\nname = \"none\""),
                          {},
                          "axis.choice: expected different names, found 'none' twice"},
        InvalidExperiment{"AxisWithTheNameOfAColumn",
                          axis_named("false_flips"),
                          {},
                          "axis: expected a name that is not a column of the results, found 'false_flips'"},
        InvalidExperiment{"TooManyCells", many_cells(5), {}, "short: expected at most 10000 cells, found more"},
        InvalidExperiment{"TooManyTrialsInAllCells",
                          many_cells(3),
                          {"--trials", "100000"},
                          "short: expected at most 1000000 trials, found 100000000"},
        InvalidExperiment{"NoSuchRoom", with_line("room = \"gone.hdr\""), {}, "unknown room 'gone.hdr'"},
        InvalidExperiment{"NoSuchField", with_line("field = \"spll\""), {}, "unknown field 'spll' (did you mean 'spl"},
        InvalidExperiment{"NoSuchParameters",
                          with_line("params = [\"papre\"]"),
                          {},
                          "expected a file, or a name in assets/parameters, found neither (did you mean 'paper'?)"},
        InvalidExperiment{
            "NoSuchBehavior", with_line("with = [\n\"look_bak\"]"), {}, "short.toml:18: unknown behavior 'look_bak'"},
        InvalidExperiment{"NoSuchBehaviorInAPlan",
                          with_line("with = [\"look_bak\"]"),
                          {"--plan"},
                          "short.toml:17: unknown behavior 'look_bak'"},
        InvalidExperiment{"NoSuchBehaviorToLeaveOut",
                          with_line("without = [\"look_back\"]"),
                          {},
                          "short.toml:17: without look_back: unknown behavior of scenario mirrored_placement"},
        InvalidExperiment{"NoSuchParameter",
                          with_line("parameters.mirrored_placement.lern = 40.0"),
                          {"--plan"},
                          "short.toml:17: unknown parameter 'mirrored_placement.lern'"},
        InvalidExperiment{"AParameterOutOfItsRange",
                          with_line("parameters.orientation.lingering = 7"),
                          {},
                          "short.toml:17: parameter orientation.lingering: invalid value '7'"},
        InvalidExperiment{
            "NoSuchState",
            with_line("measured_from = \"laerning\""),
            {"--plan"},
            "short.toml:17: scenario mirrored_placement: unknown state 'laerning' (did you mean 'learning'?)"},
        InvalidExperiment{"NoSuchScenario", with_line("scenario = \"../x\""), {}, "../x"}),
    [](const auto& each) { return std::string(each.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Options, InvalidExperimentTest,
    ::testing::Values(InvalidExperiment{"NoTrials", kShort, {"--trials", "0"}, "--trials"},
                      InvalidExperiment{"NegativeTrials", kShort, {"--trials", "-1"}, "--trials"},
                      InvalidExperiment{"HugeTrials", kShort, {"--trials", "99999999999999999999"}, "--trials"},
                      InvalidExperiment{"ManyJobs", kShort, {"--jobs", "1001"}, "--jobs"},
                      InvalidExperiment{"Width", kShort, {"--width", "200"}, "--width"},
                      InvalidExperiment{"Seed", kShort, {"--seed", "-1"}, "--seed"},
                      InvalidExperiment{"Task", kShort, {"--task", "0"}, "unknown task 0 (expected 1 to 4)"},
                      InvalidExperiment{"TaskBeyondAll", kShort, {"--task", "5"}, "unknown task 5 (expected 1 to 4)"},
                      InvalidExperiment{"TaskWithoutEnd",
                                        kShort,
                                        {"--tasks", "1-"},
                                        "expected a list of tasks, as in 17, 1-64 or 1-64,70, found '1-'"},
                      InvalidExperiment{"TasksBackwards",
                                        kShort,
                                        {"--tasks", "3-1"},
                                        "expected a range whose start is before its end, found '3-1'; write 1-3"},
                      InvalidExperiment{"TasksWithAGap",
                                        kShort,
                                        {"--tasks", "1,,2"},
                                        "expected a list of tasks, as in 17, 1-64 or 1-64,70, found '1,,2'"},
                      InvalidExperiment{"TasksInWords",
                                        kShort,
                                        {"--tasks", "all"},
                                        "expected a list of tasks, as in 17, 1-64 or 1-64,70, found 'all'"},
                      InvalidExperiment{"AnOutputAmongTheScripts",
                                        kShort,
                                        {"--json", (kProjectFolder / "scripts/behaviors/head_scan.lua").string()},
                                        "expected a file outside the folder of scripts, found one in it"},
                      InvalidExperiment{"PlanWithResume", kShort, {"--plan", "--resume"}, "--plan"}),
    [](const auto& each) { return std::string(each.param.name); });

TEST_F(ShortExperiment, ThatIsAFolderIsRefused) {
  const ProgramRun refused = run_reorient({"experiment", folder.path().string()});
  EXPECT_EQ(refused.code, kBadInput);
  EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
}

}  // namespace
}  // namespace reorient

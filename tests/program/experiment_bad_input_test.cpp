// SPDX-License-Identifier: MIT
// Experiments that cannot be meant: refused in one line before anything is run or written.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/program/short_experiment.h"

namespace reorient {
namespace {

struct UnmeantExperiment {
  const char* name;
  std::string text;
  std::vector<std::string> words;
  const char* told;
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

std::string axis_called(const std::string& name) {
  return with_line("[[axis]]\nname = \"" + name + "\"\n[[axis.choice]]\nname = \"a\"");
}

class UnmeantExperimentTest : public ShortExperiment, public ::testing::WithParamInterface<UnmeantExperiment> {};

TEST_P(UnmeantExperimentTest, IsRefusedInOneLineAndLeavesNothing) {
  folder.write("short.toml", GetParam().text);
  std::vector<std::string> all = GetParam().words;
  all.insert(all.end(), {"--out", path("out")});
  expect_refused(all, GetParam().told);
  EXPECT_FALSE(std::filesystem::exists(path("out")));
}

INSTANTIATE_TEST_SUITE_P(
    Files, UnmeantExperimentTest,
    ::testing::Values(
        UnmeantExperiment{"MisspeltKey", with_line("scenari = \"fallen\""), {}, "did you mean 'scenario'?"},
        UnmeantExperiment{
            "ImpossibleValue", with_line("limit = -1"), {}, ":17: limit: expected a number from 0 to 86400, found -1"},
        UnmeantExperiment{"WrongType",
                          with_line("seconds = \"long\""),
                          {},
                          ":17: seconds: expected a number from 1 to 86400, found 'long'"},
        UnmeantExperiment{"TrialsBeyondAllMeasure", "trials = 99999999999999999999\n", {}, "short.toml:1: "},
        UnmeantExperiment{"Letters", "\xFF\xFE\x01 = 3", {}, "short.toml:1: "},
        UnmeantExperiment{"Nothing", "", {}, "title: expected one sentence"},
        UnmeantExperiment{"AxisTwice", axis_called("mode"), {}, "axis: expected different names, found 'mode' twice"},
        UnmeantExperiment{"ChoiceTwice",
                          with_line("[[axis.choice]]\nname = \"none\""),
                          {},
                          "axis.choice: expected different names, found 'none' twice"},
        UnmeantExperiment{"AxisCalledAsANumberOfTheRow",
                          axis_called("false_flips"),
                          {},
                          "axis: expected a name that is not a column of the results, found 'false_flips'"},
        UnmeantExperiment{
            "MoreCellsThanAnybodyCanRead", many_cells(5), {}, "short: expected at most 10000 cells, found more"},
        UnmeantExperiment{"MoreTrialsThanAnybodyCanWaitFor",
                          many_cells(3),
                          {"--trials", "100000"},
                          "short: expected at most 1000000 trials, found 100000000"},
        UnmeantExperiment{"NoSuchRoom", with_line("room = \"gone.hdr\""), {}, "unknown room 'gone.hdr'"},
        UnmeantExperiment{"NoSuchField", with_line("field = \"spll\""), {}, "did you mean 'spl"},
        UnmeantExperiment{"NoSuchParameters", with_line("params = [\"papre\"]"), {}, "did you mean 'paper'?"},
        UnmeantExperiment{
            "NoSuchBehavior", with_line("with = [\n\"look_bak\"]"), {}, "short.toml:18: unknown behavior 'look_bak'"},
        UnmeantExperiment{"NoSuchBehaviorInAPlan",
                          with_line("with = [\"look_bak\"]"),
                          {"--plan"},
                          "short.toml:17: unknown behavior 'look_bak'"},
        UnmeantExperiment{"NoSuchBehaviorToLeaveOut",
                          with_line("without = [\"look_back\"]"),
                          {},
                          "short.toml:17: without look_back: unknown behavior of scenario mirrored_placement"},
        UnmeantExperiment{"NoSuchParameter",
                          with_line("parameters.mirrored_placement.lern = 40.0"),
                          {"--plan"},
                          "short.toml:17: unknown parameter 'mirrored_placement.lern'"},
        UnmeantExperiment{
            "AParameterOutOfItsRange", with_line("parameters.orientation.lingering = 7"), {}, "short.toml:17: "},
        UnmeantExperiment{
            "NoSuchState",
            with_line("measured_from = \"laerning\""),
            {"--plan"},
            "short.toml:17: scenario mirrored_placement: unknown state 'laerning' (did you mean 'learning'?)"},
        UnmeantExperiment{"NoSuchScenario", with_line("scenario = \"../x\""), {}, "../x"}),
    [](const auto& each) { return std::string(each.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Options, UnmeantExperimentTest,
    ::testing::Values(UnmeantExperiment{"NoTrials", kShort, {"--trials", "0"}, "--trials"},
                      UnmeantExperiment{"NegativeTrials", kShort, {"--trials", "-1"}, "--trials"},
                      UnmeantExperiment{"HugeTrials", kShort, {"--trials", "99999999999999999999"}, "--trials"},
                      UnmeantExperiment{"ManyJobs", kShort, {"--jobs", "1001"}, "--jobs"},
                      UnmeantExperiment{"Width", kShort, {"--width", "200"}, "--width"},
                      UnmeantExperiment{"Seed", kShort, {"--seed", "-1"}, "--seed"},
                      UnmeantExperiment{"Task", kShort, {"--task", "0"}, "unknown task 0 (expected 1 to 4)"},
                      UnmeantExperiment{"TaskBeyondAll", kShort, {"--task", "5"}, "unknown task 5 (expected 1 to 4)"},
                      UnmeantExperiment{"TaskWithoutEnd",
                                        kShort,
                                        {"--tasks", "1-"},
                                        "expected a list of tasks, as in 17, 1-64 or 1-64,70, found '1-'"},
                      UnmeantExperiment{"TasksBackwards",
                                        kShort,
                                        {"--tasks", "3-1"},
                                        "expected a range whose start is before its end, found '3-1'; write 1-3"},
                      UnmeantExperiment{"TasksWithAGap",
                                        kShort,
                                        {"--tasks", "1,,2"},
                                        "expected a list of tasks, as in 17, 1-64 or 1-64,70, found '1,,2'"},
                      UnmeantExperiment{"TasksInWords",
                                        kShort,
                                        {"--tasks", "all"},
                                        "expected a list of tasks, as in 17, 1-64 or 1-64,70, found 'all'"},
                      UnmeantExperiment{"AnOutputInThePlaceOfAScript",
                                        kShort,
                                        {"--json", (kProjectFolder / "scripts/behaviors/head_scan.lua").string()},
                                        "expected a file outside the folder of scripts, found one in it"},
                      UnmeantExperiment{"PlanGoesOnNowhere", kShort, {"--plan", "--resume"}, "--plan"}),
    [](const auto& each) { return std::string(each.param.name); });

TEST_F(ShortExperiment, ThatIsAFolderIsRefused) {
  const ProgramRun refused = run_reorient({"experiment", folder.path().string()});
  EXPECT_EQ(refused.code, kBadInput);
  EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
}

}  // namespace
}  // namespace reorient

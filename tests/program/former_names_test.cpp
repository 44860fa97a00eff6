// SPDX-License-Identifier: MIT
// Names of earlier versions still work, each with a warning that names the present one.
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/program/child_program.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

/// The program as a separate process, since its log is not part of what run_reorient() returns.
ProgramRun run_child(const std::filesystem::path& folder, const std::vector<std::string>& words) {
  ChildProgram program(folder, words);
  const int code = program.wait();
  return {code, program.out(), program.err()};
}

ProgramRun run_for_a_moment(const std::filesystem::path& folder, std::vector<std::string> words) {
  for (const char* const one : {"--width", "160", "--no-pictures", "--seconds", "2"}) words.emplace_back(one);
  return run_child(folder, words);
}

std::string digest_line(const ProgramRun& run) {
  const std::size_t begin = run.out.find("digest: ");
  return begin == std::string::npos ? "none: " + run.err : run.out.substr(begin, 24);
}

TEST(FormerNames, OfAScenarioAndItsParametersGiveTheSameRun) {
  const TemporaryFolder folder;
  const ProgramRun former = run_for_a_moment(folder.path(), {"run", "turned_round", "--set", "turned_round.learn=1"});
  const ProgramRun present =
      run_for_a_moment(folder.path(), {"run", "mirrored_placement", "--set", "mirrored_placement.learn=1"});
  EXPECT_EQ(digest_line(former), digest_line(present));
  EXPECT_NE(former.err.find("turned_round is a former name: use mirrored_placement"), std::string::npos) << former.err;
  EXPECT_NE(former.err.find("turned_round.learn is a former name: use mirrored_placement.learn"), std::string::npos);
  EXPECT_EQ(present.err.find("former name"), std::string::npos) << present.err;
}

TEST(FormerNames, OfAChoiceIsAccepted) {
  const TemporaryFolder folder;
  const ProgramRun run = run_for_a_moment(folder.path(), {"run", "trial", "--set", "trial.event=turned_round"});
  EXPECT_NE(run.err.find("turned_round is a former name: use mirrored_placement"), std::string::npos) << run.err;
  EXPECT_NE(digest_line(run).find("digest: "), std::string::npos) << run.err;
}

TEST(FormerNames, OfAnExperimentIsAccepted) {
  const TemporaryFolder folder;
  const ProgramRun run = run_child(folder.path(), {"experiment", "turned_round", "--plan"});
  EXPECT_EQ(run.code, kSuccess) << run.err;
  EXPECT_NE(run.err.find("turned_round is a former name: use mirrored_placement"), std::string::npos) << run.err;
}

TEST(FormerNames, OfATableAndOfFieldsStillWorkInScripts) {
  const TemporaryFolder folder;
  const std::filesystem::path scripts = copy_scripts(folder.path());
  folder.write("scripts/scenarios/old.lua", R"(scenario "old" { initial = "a", state "a" {
  enter = function() experimenter.put_down(1, 1, 0) end,
  update = function()
    if robot.undisturbed_for >= 0 and views.telling_worth >= 0 and views.unknown_worth >= 0 then
      verdict.succeed("all are there")
    end
  end } })");
  const ProgramRun run = run_for_a_moment(folder.path(), {"run", "old", "--scripts", scripts.string()});
  EXPECT_EQ(run.code, kSuccess) << run.out << run.err;
  for (const char* const name : {"experimenter is a former name: use operator",
                                 "robot.undisturbed_for is a former name: use robot.time_since_disturbance",
                                 "views.telling_worth is a former name: use views.best_score",
                                 "views.unknown_worth is a former name: use views.unknown_score"})
    EXPECT_NE(run.err.find(name), std::string::npos) << name << " in " << run.err;
}

TEST(FormerNames, OfAScenarioRefersToTheTeamsOwnScenarioIfItExists) {
  const TemporaryFolder folder;
  const std::filesystem::path scripts = copy_scripts(folder.path());
  folder.write("scripts/scenarios/turned_round.lua", R"(local p = param { learn = { 1.0, range = { 0, 9 }, doc = "x" } }
scenario "turned_round" { initial = "a", state "a" {
  update = function() if p.learn == 7 then verdict.succeed("it is ours") end end } })");
  const ProgramRun run = run_for_a_moment(
      folder.path(), {"run", "turned_round", "--scripts", scripts.string(), "--set", "turned_round.learn=7"});
  EXPECT_EQ(run.code, kSuccess) << run.out << run.err;
  EXPECT_EQ(run.err.find("former name"), std::string::npos) << run.err;
}

TEST(FormerNames, OfAFieldIsAcceptedInAScriptedTest) {
  const TemporaryFolder folder;
  const std::filesystem::path scripts = copy_scripts(folder.path());
  folder.write("scripts/tests/old_test.lua", R"(test("a former name", function()
  load_behavior "head_scan"
  set_world { robot = { undisturbed_for = 7 } }
  advance(0.1)
  expect.equal(world_value("robot.time_since_disturbance"), 7)
end))");
  const ProgramRun run = run_child(folder.path(), {"test", (scripts / "tests/old_test.lua").string()});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
}

TEST(FormerNames, OfAStateStillWorksInScriptedTests) {
  const TemporaryFolder folder;
  const std::filesystem::path scripts = copy_scripts(folder.path());
  folder.write("scripts/tests/old_test.lua", R"(test("a former state", function()
  load_behavior "orientation"
  advance(0.1)
  expect.state("orientation", "watching/in doubt")
end))");
  const ProgramRun run = run_child(folder.path(), {"test", (scripts / "tests/old_test.lua").string()});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_NE(run.err.find(R"("watching/in doubt" is a former name: use "watching/unconfirmed")"), std::string::npos)
      << run.err;
}

TEST(FormerNames, OfALibraryFunctionGivesAWarningInARun) {
  const TemporaryFolder folder;
  const std::filesystem::path scripts = copy_scripts(folder.path());
  folder.write("scripts/scenarios/old.lua", R"(local decision = require "lib.decision"
scenario "old" { initial = "a", state "a" {
  update = function() if decision.in_doubt() > 0 and decision.in_peace() == decision.confirmed_threshold() then verdict.succeed("it is there") end end } })");
  const ProgramRun run = run_for_a_moment(folder.path(), {"run", "old", "--scripts", scripts.string()});
  EXPECT_EQ(run.code, kSuccess) << run.out << run.err;
  EXPECT_NE(run.err.find("decision.in_doubt is a former name: use decision.unconfirmed_threshold"), std::string::npos)
      << run.err;
}

TEST(FormerNames, OfARenamedParameterSetsThePresentOne) {
  const TemporaryFolder folder;
  const ProgramRun former = run_for_a_moment(folder.path(), {"run", "--set", "color.grey_within=9"});
  const ProgramRun present = run_for_a_moment(folder.path(), {"run", "--set", "color.gray_within=9"});
  EXPECT_EQ(digest_line(former), digest_line(present));
  EXPECT_NE(former.err.find("color.grey_within is a former name: use color.gray_within"), std::string::npos)
      << former.err;
}

TEST(FormerNames, OfATableIsReportedByTheCheck) {
  const TemporaryFolder folder;
  const std::filesystem::path scripts = copy_scripts(folder.path());
  folder.write("scripts/scenarios/old.lua",
               "scenario \"old\" { initial = \"a\", state \"a\" { enter = function() experimenter.pick_up() end } }");
  const ProgramRun run = run_child(folder.path(), {"check", "--scripts", scripts.string()});
  EXPECT_NE(run.out.find("warning: experimenter is a former name: use operator"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace reorient

// SPDX-License-Identifier: MIT
// The program from the command line to its files.
#include <fstream>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/child_program.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

TEST(Program, HelpsWithExamples) {
  for (const auto& words :
       {std::vector<std::string>{"--help"}, {"run", "--help"}, {"test", "--help"}, {"version", "--help"}}) {
    const ProgramRun run = run_reorient(words);
    SCOPED_TRACE(words.front());
    EXPECT_EQ(run.code, kSuccess);
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out.find("Examples:\n"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("\n  reorient "), std::string::npos);
  }
  EXPECT_NE(run_reorient({"run", "--help"}).out.find("--no-room-awareness"), std::string::npos);
}

TEST(Program, SuggestsASubcommandForAMistypedOne) {
  const ProgramRun run = run_reorient({"chek"});
  EXPECT_EQ(run.code, kBadInput);
  EXPECT_NE(run.err.find("did you mean 'check'?"), std::string::npos) << run.err;
}

TEST(Program, ColorsItsLogOnRequest) {
  const TemporaryFolder folder;
  const std::string strange = folder.write("strange.toml", "[stranger]\nkey = 1\n").string();
  const auto colored = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"params", "head_scan", "--params", strange});
    ChildProgram program(folder.path(), words);
    EXPECT_EQ(program.wait(), kSuccess);
    EXPECT_NE(program.err().find("'stranger'"), std::string::npos);
    return program.err().find('\033') != std::string::npos;
  };
  EXPECT_FALSE(colored({})) << "the output is not a terminal";
  EXPECT_TRUE(colored({"--color", "always"}));
  EXPECT_FALSE(colored({"--color", "never"}));
}

TEST(Program, LogsForeignTextAsOneLineWithTheRobotsTime) {
  const TemporaryFolder folder;
  const std::filesystem::path scripts = copy_scripts(folder.path());
  std::ofstream(scripts / "behaviors/forger.lua") << R"(behavior "forger" { initial = "waiting",
  state "waiting" { { "forging", after = 0.1 } },
  state "forging" { enter = function() log.info("hello\27[2J\r\n[info] forged") end } })";
  const std::string strange = folder.write("strange\x1B[2J\nforged.toml", "[stranger]\nkey = 1\n").string();
  ChildProgram program(folder.path(), {"run", "--seconds", "1", "--width", "160", "--no-pictures", "--scripts",
                                       scripts.string(), "--with", "forger", "--params", strange});
  program.wait();
  const std::string log = program.err();
  EXPECT_EQ(log.find('\x1B'), std::string::npos) << log;
  EXPECT_NE(log.find("s] [info] forger (forging): hello\\x1B[2J\\x0D [info] forged\n"), std::string::npos) << log;
  EXPECT_NE(log.find("[0.1"), std::string::npos) << "the robot's time: " << log;
  EXPECT_NE(log.find("[warning] "), std::string::npos) << log;
  EXPECT_NE(log.find("strange\\x1B[2J forged.toml"), std::string::npos) << log;
}

TEST(Program, PrintsItsVersion) {
  const ProgramRun run = run_reorient({"version"});
  EXPECT_EQ(run.code, kSuccess);
  EXPECT_TRUE(run.out.starts_with("reorient ")) << run.out;
  EXPECT_NE(run.out.find_first_of("0123456789"), std::string::npos);
  EXPECT_EQ(run.err, "");
}

TEST(Program, PrintsItsVersionForTheUsualOption) {
  const ProgramRun run = run_reorient({"--version"});
  EXPECT_EQ(run.code, kSuccess);
  EXPECT_EQ(run.out, run_reorient({"version"}).out);
}

TEST(Program, LeavesABehaviorOut) {
  const ProgramRun run = run_shortly({"--without", "head_scan", "--without", "goal_search"});
  EXPECT_EQ(run.out.find("goal_search"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("orientation"), std::string::npos) << run.out;
  const ProgramRun slip = run_shortly({"--without", "head_scann"});
  EXPECT_EQ(slip.code, kBadInput);
  EXPECT_NE(slip.err.find("unknown behavior of scenario mirrored_placement (did you mean 'head_scan'?)"),
            std::string::npos)
      << slip.err;
}

TEST(Program, LoadsNoBehaviorTwice) {
  for (const auto& words : {std::vector<std::string>{"--with", "head_scan"},
                            {"--with", "paper/paper_training", "--with", "paper/paper_training"}}) {
    const ProgramRun run = run_shortly(words);
    EXPECT_EQ(run.code, kBadInput);
    EXPECT_NE(run.err.find("expected a behavior that is not loaded yet"), std::string::npos) << run.err;
  }
}

TEST(Program, LeavesTheVerdictToTheScenario) {
  const TemporaryFolder folder;
  const std::filesystem::path scripts = copy_scripts(folder.path());
  folder.write("scripts/scenarios/easy.lua", R"(scenario "easy" { initial = "a", state "a" {
  update = function()
    if clock.time > 1.05 then verdict.succeed("that is all")
    elseif clock.time > 1.0 then operator.put_down(-3, 2, 1) end end } })");
  const ProgramRun run =
      run_reorient({"run", "easy", "--scripts", scripts.string(), "--width", "160", "--no-pictures", "--log", "off"});
  EXPECT_EQ(run.code, kSuccess) << run.out << run.err;  // although it was placed elsewhere at the end
  EXPECT_NE(run.out.find("right: that is all\n"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("belief wrong at the end"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("belief wrong at 0"), std::string::npos) << run.out;
}

TEST(Program, NamesAStoppedBehavior) {
  const TemporaryFolder folder;
  const std::filesystem::path scripts = copy_scripts(folder.path());
  folder.write("scripts/behaviors/broken.lua",
               "behavior \"broken\" { initial = \"a\", state \"a\" { update = function() local x = nil + 1 end } }");
  folder.write("scripts/behaviors/rude.lua",
               "behavior \"rude\" { initial = \"a\", state \"a\" { update = function() "
               "log.info(\"\\xff \\xc3( \\x01\") end } }");
  const std::filesystem::path json = folder.path() / "run.json";
  const ProgramRun run =
      run_shortly({"--scripts", scripts.string(), "--with", "broken", "--with", "rude", "--json", json.string()});
  EXPECT_NE(run.out.find("behaviors/broken.lua was stopped: "), std::string::npos) << run.out;
  std::ifstream file(json);
  EXPECT_EQ(nlohmann::json::parse(file)["stopped"][0]["script"], "behaviors/broken.lua");
}

TEST(Program, RepeatsARunWithItsSeedAndNotWithAnother) {
  const std::string digest = digest_of(run_shortly({"--seed", "5"}));
  EXPECT_EQ(digest.size(), std::string("digest: 0123456789abcdef").size());
  EXPECT_EQ(digest_of(run_shortly({"--seed", "5"})), digest);
  EXPECT_NE(digest_of(run_shortly({"--seed", "6"})), digest);
  EXPECT_NE(digest_of(run_shortly({"--seed", "5", "--hall-seed", "2"})), digest);
  EXPECT_NE(digest_of(run_shortly({"--seed", "5", "--no-room-awareness"})), digest);
}

TEST(Program, EndsWrongAtTheTimeLimit) {
  const ProgramRun run = run_shortly({});
  EXPECT_EQ(run.code, kWrong);
  EXPECT_NE(run.out.find("did not end in time"), std::string::npos) << run.out;
}

TEST(Program, TakesParametersFromTheFileAndTheCommandLine) {
  const TemporaryFolder folder;
  const std::string file = folder.write("mine.toml", "[pose_filter]\nparticles = 50\n").string();
  const std::string digest = digest_of(run_shortly({}));
  const std::string changed = digest_of(run_shortly({"--set", "pose_filter.particles=50"}));
  EXPECT_NE(changed, digest);
  EXPECT_EQ(digest_of(run_shortly({"--params", file})), changed);
  EXPECT_EQ(digest_of(run_shortly({"--params", file, "--set", "pose_filter.particles=200"})), digest);
}

TEST(Program, WritesTheSummaryForPrograms) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "summary.json";
  const ProgramRun run = run_shortly({"--seed", "9", "--json", file.string()});
  std::ifstream stream(file);
  const nlohmann::json json = nlohmann::json::parse(stream);
  for (const char* key : {"scenario",
                          "room",
                          "seed",
                          "room_awareness",
                          "correct",
                          "succeeded",
                          "verdict",
                          "belief_wrong_at_seconds",
                          "corrected_after_seconds",
                          "wrong_periods",
                          "longest_wrong_seconds",
                          "position_error_meters",
                          "rotation_error_degrees",
                          "flips",
                          "purges",
                          "resets",
                          "seconds",
                          "frames",
                          "frames_per_second",
                          "digest",
                          "belief",
                          "truth",
                          "commands"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json["seed"], 9);
  EXPECT_EQ(json["scenario"], "mirrored_placement");
  EXPECT_TRUE(json["correct"].get<bool>());  // it was not mirrored yet
  EXPECT_FALSE(json["succeeded"].get<bool>());
  EXPECT_NEAR(json["seconds"].get<double>(), 3.0, 0.05);
  EXPECT_LT(json["position_error_meters"].get<double>(), 1.0);
  EXPECT_EQ("digest: " + json["digest"].get<std::string>(), digest_of(run));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "no temporary file is left";
}

TEST(Program, WritesFourPictures) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "deep" / "out";
  const ProgramRun run =
      run_reorient({"run", "--seconds", "2", "--width", "160", "--log", "off", "--out", out.string()});
  EXPECT_NE(run.out.find(out.string()), std::string::npos) << run.out << run.err;
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(out)) {
    names.insert(entry.path().filename().string());
    std::string magic(4, '\0');
    std::ifstream(entry.path(), std::ios::binary).read(magic.data(), 4);
    EXPECT_EQ(magic, "\x89PNG") << entry.path();
  }
  EXPECT_EQ(names,
            (std::set<std::string>{"camera_view.png", "confidences.png", "reorientations.png", "world_view.png"}));
}

TEST(Program, FailsWithAScriptedTestThatFails) {
  const TemporaryFolder folder;
  const std::filesystem::path scripts = copy_scripts(folder.path());
  folder.write("scripts/tests/wrong_test.lua",
               "test(\"gets up at once\", function()\n  load_behavior \"get_up\"\n  advance(0.1)\n  "
               "expect.get_up(true)\nend)\n");
  const ProgramRun run = run_reorient({"test", "--scripts", scripts.string()});
  EXPECT_EQ(run.code, kWrong);
  EXPECT_NE(run.out.find("tests/wrong_test.lua:4"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find(" 1 failed"), std::string::npos) << run.out;
}

TEST(MainJob, EndsRight) {
  const ProgramRun run = run_reorient({"run", "--width", "160", "--no-pictures", "--log", "off"});
  EXPECT_EQ(run.code, kSuccess) << run.out << run.err;
  EXPECT_NE(run.out.find("flip_pose"), std::string::npos);
  EXPECT_NE(run.out.find("\nright: "), std::string::npos);
}

TEST(MainJob, EndsWrongWithoutRoomAwareness) {
  const ProgramRun run =
      run_reorient({"run", "--width", "160", "--no-pictures", "--log", "off", "--no-room-awareness"});
  EXPECT_EQ(run.code, kWrong) << run.out << run.err;
  EXPECT_NE(run.out.find("not corrected"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace reorient

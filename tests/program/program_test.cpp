// The program from the command line to its files.
#include <fstream>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

std::string digest_of(const ProgramRun& run) {
  const std::size_t place = run.out.rfind("digest: ");
  return place == std::string::npos ? std::string() : run.out.substr(place);
}

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

TEST(Program, GuessesWhichSubcommandWasMeant) {
  const ProgramRun run = run_reorient({"chek"});
  EXPECT_EQ(run.code, kBadInput);
  EXPECT_NE(run.err.find("did you mean 'check'?"), std::string::npos) << run.err;
}

TEST(Program, SaysItsVersion) {
  const ProgramRun run = run_reorient({"version"});
  EXPECT_EQ(run.code, kSuccess);
  EXPECT_TRUE(run.out.starts_with("reorient ")) << run.out;
  EXPECT_NE(run.out.find_first_of("0123456789"), std::string::npos);
  EXPECT_EQ(run.err, "");
}

TEST(Program, RepeatsARunWithItsSeedAndNotWithAnother) {
  const std::string digest = digest_of(run_shortly({"--seed", "5"}));
  EXPECT_EQ(digest.size(), std::string("digest: 0123456789abcdef\n").size());
  EXPECT_EQ(digest_of(run_shortly({"--seed", "5"})), digest);
  EXPECT_NE(digest_of(run_shortly({"--seed", "6"})), digest);
  EXPECT_NE(digest_of(run_shortly({"--seed", "5", "--hall-seed", "2"})), digest);
  EXPECT_NE(digest_of(run_shortly({"--seed", "5", "--no-room-awareness"})), digest);
}

TEST(Program, EndsWrongWhereTheTimeIsUpTooEarly) {
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
                          "position_error_metres",
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
  EXPECT_EQ(json["scenario"], "turned_round");
  EXPECT_TRUE(json["correct"].get<bool>());  // nobody has turned it round yet
  EXPECT_FALSE(json["succeeded"].get<bool>());
  EXPECT_NEAR(json["seconds"].get<double>(), 3.0, 0.05);
  EXPECT_LT(json["position_error_metres"].get<double>(), 1.0);
  EXPECT_EQ("digest: " + json["digest"].get<std::string>() + "\n", digest_of(run));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "nothing is left beside it";
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
  EXPECT_NE(run.out.find(" 1 failed"), std::string::npos);
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

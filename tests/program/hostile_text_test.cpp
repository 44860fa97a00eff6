// SPDX-License-Identifier: MIT
// Text of others in the output: names, reasons and messages of scripts, names of files, titles. It cannot look like a
// line of the program.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "program/shell_word.h"
#include "tests/paths.h"
#include "tests/program/program_run.h"
#include "tests/program/short_experiment.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

using Words = std::vector<std::string>;

// Names of states, reasons and choices with line ends are refused when a script is loaded.
constexpr const char* kHostile = R"(--- Shouts.
local p = param {
  level = { 0.5, range = { 0, 1 }, unit = "m\nFORGED unit", doc = "a level\nFORGED description" },
}
behavior "hostile" { initial = "first",
  state "first" {
    update = function()
      log.info("said\nFORGED log \27[2J")
      log.note("noted\r\nFORGED note")
      command.pause_training()
    end,
    { "second", after = 0.2 },
  },
  state "second" {
    update = function() error("failed\nFORGED error", 0) end,
    { "third", when = function() return p.level > 0.9 end },
  },
  state "third" {},
}
)";

constexpr const char* kShout = R"(--- Shouts.
scenario "shout" { behaviors = { "hostile" }, initial = "begun",
  state "begun" {
    update = function() log.note("noted\nFORGED note") end,
    { "over", after = 0.5 },
  },
  state "over" { enter = function() verdict.fail("lost\nFORGED verdict") end },
}
)";

constexpr const char* kTest = R"(test("is named\nFORGED test", function()
  print("printed\nFORGED text")
  load_behavior "hostile"
  advance(0.1)
  expect.log("other\nFORGED text")
  expect.state("hostile", "third")
  expect.equal("a\nFORGED value", "a FORGED value")
  expect.equal({ ["key\nFORGED"] = "a\nFORGED value" }, {})
  error("raised\nFORGED error")
end)
)";

class HostileText : public ::testing::Test {
 protected:
  HostileText() : scripts_(copy_scripts(folder_.path())) {
    folder_.write("scripts/behaviors/hostile.lua", kHostile);
    folder_.write("scripts/behaviors/file\nFORGED name.lua",
                  "--- Shouts.\nbehavior \"file\" { initial = \"a\", state \"a\" {} }");
    folder_.write("scripts/scenarios/shout.lua", kShout);
    folder_.write("scripts/tests/shout_test.lua", kTest);
  }

  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  /// Its output contains hostile text, but none that begins a line or controls a terminal.
  static ProgramRun expect_no_forged_line(const Words& words) {
    ProgramRun run = run_reorient(words);
    const std::string all = run.out + run.err;
    EXPECT_NE(all.find("FORGED"), std::string::npos) << words.front() << "\n" << all;
    std::istringstream lines(all);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t begin = line.find_first_not_of(" \t");
      EXPECT_TRUE(begin == std::string::npos || !line.substr(begin).starts_with("FORGED"))
          << words.front() << ": " << line;
      EXPECT_EQ(line.find_first_of("\x1B\r"), std::string::npos) << words.front() << ": " << line;
    }
    return run;
  }
  ProgramRun of_scripts(Words words) const {
    words.insert(words.end(), {"--scripts", scripts_.string()});
    return expect_no_forged_line(words);
  }

  TemporaryFolder folder_;
  std::filesystem::path scripts_;
};

TEST_F(HostileText, OfScriptsForgesNoLineOfTheCommandsForScripts) {
  for (const Words& words : std::vector<Words>{
           {"list"}, {"list", "behaviors", "--names"}, {"params", "hostile"}, {"check"}, {"test", "--coverage"}})
    of_scripts(words);
  expect_no_forged_line({"complete", "run", "--scripts", scripts_.string(), "--with", ""});
}

TEST_F(HostileText, OfATestForgesNoLine) {
  const ProgramRun run = of_scripts({"test", (scripts_ / "tests/shout_test.lua").string()});
  EXPECT_NE(run.out.find("expected \"a FORGED value\"\n        actual \"a\\nFORGED value\""), std::string::npos)
      << "different values are shown as different: " << run.out;
}

TEST_F(HostileText, OfARunForgesNoLineOfItsOutputAndItsRecording) {
  const std::string recording = path("run\nFORGED recording.mcap"), model = path("run\nFORGED model");
  const ProgramRun run = of_scripts({"run", "shout", "--width", "160", "--seconds", "2", "--log", "off", "--record",
                                     recording, "--model", model, "--every-transition", "--out",
                                     path("out\nFORGED folder"), "--save-params", path("params\nFORGED file.toml")});
  EXPECT_NE(run.out.find("lost FORGED verdict"), std::string::npos) << run.out;
  const std::string other = path("other\nFORGED scripts");
  std::filesystem::copy(scripts_, other, std::filesystem::copy_options::recursive);
  for (const Words& words : std::vector<Words>{
           {"recording", "info", recording},
           {"recording", "export", recording, "--csv", "events"},
           {"recording", "cut", recording, "--to", "1", "--out", path("cut\nFORGED recording.mcap")},
           {"recording", "recover", recording, "--out", path("whole\nFORGED recording.mcap")},
           {"recording", "pictures", recording, "--at", "0.5", "--out", path("pictures\nFORGED folder")},
           {"replay", recording, "--events"},
           {"replay", recording, "--set", "hostile.level=0.95", "--events"},
           {"record-test", recording, "--to", "1", "--name", "made", "--scripts", other},
           {"room", "rate", recording},
           {"model", "info", model},
       })
    expect_no_forged_line(words);
}

TEST_F(HostileText, OfAnImageForgesNoLineOfLook) {
  if (*kDecoder == '\0') GTEST_SKIP() << "built without OpenCV's imgcodecs and videoio (tools/packages-footage)";
  setenv("REORIENT_DECODER", kDecoder, 1);
  const std::string image =
      folder_.write("image\nFORGED name.ppm", "P6 160 120 255\n" + std::string(57600, '\x60')).string();
  expect_no_forged_line({"look", image, "--out", path("out\nFORGED folder")});
}

TEST_F(HostileText, OfAnExperimentForgesNoLineOfItsTables) {
  std::string text = kShort;
  const auto replace = [&text](const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  };
  replace("Who is right?", "Who\\nFORGED title");
  replace("name = \"none\"", "name = \"none\\nFORGED choice\"");
  replace("trials = 2", "trials = 1");
  const std::string file = folder_.write("file\nFORGED experiment.toml", text).string(),
                    table = path("table\nFORGED.json");
  expect_no_forged_line({"--log", "off", "experiment", file, "--out", path("out\nFORGED folder"), "--json", table,
                         "--report", path("report\nFORGED folder")});
  expect_no_forged_line({"experiment", "compare", table, table});
  expect_no_forged_line(
      {"experiment", "compare", table, "--axis", "mode", "--from", "default", "--to", "none\nFORGED choice"});
}

TEST_F(HostileText, OfMistakesForgesNoLine) {
  for (const Words& words : std::vector<Words>{{"run", "a\nFORGED scenario"},
                                               {"run", "--room", "a\nFORGED room.hdr"},
                                               {"replay", "a\nFORGED recording"},
                                               {"room", "rate", "a\nFORGED room"},
                                               {"model", "info", "a\nFORGED model"},
                                               {"a\nFORGED command"},
                                               {"params", "--set", "a\nFORGED parameter=1"}})
    EXPECT_EQ(expect_no_forged_line(words).code, kBadInput) << words.front();
}

TEST(ShellWord, IsOneLineThatAShellReadsAsTheWord) {
  EXPECT_EQ(shell_word("plain-1.mcap"), "plain-1.mcap");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  const std::string word = "a\n'b'\\c\x1B";
  EXPECT_EQ(shell_word(word), "$'a\\x0A\\'b\\'\\\\c\\x1B'");
}

}  // namespace
}  // namespace reorient

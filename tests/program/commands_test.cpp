// SPDX-License-Identifier: MIT
// reorient check, graph, new, params and test, as a user calls them.
#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "tests/program/child_program.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"
#include "workbench/files/input_file.h"

namespace reorient {
namespace {

class CommandsTest : public ::testing::Test {
 protected:
  CommandsTest() : scripts_(copy_scripts(folder_.path())) {}

  ProgramRun run(std::vector<std::string> words) const {
    words.insert(words.end(), {"--scripts", scripts_.string()});
    return run_reorient(words);
  }
  std::string path(const std::string& file) const { return (folder_.path() / file).string(); }

  TemporaryFolder folder_;
  std::filesystem::path scripts_;
};

TEST_F(CommandsTest, CheckFindsNothingWrongWithTheShippedScripts) {
  const ProgramRun checked = run({"check"});
  EXPECT_EQ(checked.code, kSuccess) << checked.out;
  EXPECT_NE(checked.out.find("0 errors, 0 warnings"), std::string::npos) << checked.out;
}

TEST_F(CommandsTest, CheckReportsAMistakeAndFails) {
  std::ofstream(scripts_ / "behaviors/odd.lua")
      << "local x = robot.penalised\nbehavior \"odd\" { initial = \"a\", state \"a\" {} }\n";
  const ProgramRun checked = run({"check"});
  EXPECT_EQ(checked.code, kWrong);
  EXPECT_NE(
      checked.out.find("behaviors/odd.lua:1:17: error: robot has no field 'penalised' (did you mean 'penalized'?)"),
      std::string::npos)
      << checked.out;
}

TEST_F(CommandsTest, CheckFailsOnAWarningOnlyIfStrict) {
  std::ofstream(scripts_ / "behaviors/odd.lua")
      << "behavior \"odd\" { initial = \"a\", state \"a\" { { \"b\", after = 1 } }, state \"b\" {} }\n";
  EXPECT_EQ(run({"check"}).code, kSuccess);
  EXPECT_EQ(run({"check", "--strict"}).code, kWrong);
}

TEST_F(CommandsTest, CheckRefusesAMissingPath) {
  const ProgramRun checked = run({"check", path("nothing.lua")});
  EXPECT_EQ(checked.code, kBadInput);
  EXPECT_NE(checked.err.find("nothing.lua"), std::string::npos);
}

TEST_F(CommandsTest, GraphDrawsABehaviorAndAScenario) {
  EXPECT_TRUE(run({"graph", "orientation"}).out.starts_with("stateDiagram-v2\n"));
  EXPECT_TRUE(run({"graph", "orientation", "--format", "dot"}).out.starts_with("digraph \"orientation\" {\n"));
  EXPECT_TRUE(
      run({"graph", "orientation", "--format", "json"}).out.starts_with("{\"machines\":[{\"name\":\"orientation\","));
  const ProgramRun scenario = run({"graph", "mirrored_placement"});
  EXPECT_NE(scenario.out.find("state \"carrying\" as mirrored_placement_carrying"), std::string::npos);
  EXPECT_EQ(scenario.out.find("watching"), std::string::npos) << "the behaviors of the scenario were not requested";
  EXPECT_EQ(run({"graph", (scripts_ / "behaviors/orientation.lua").string()}).code, kSuccess);
}

TEST_F(CommandsTest, GraphDrawsAScenarioWithAllItsBehaviorsInOnePicture) {
  const ProgramRun drawn = run({"graph", "kidnapped", "--with-behaviors"});
  EXPECT_EQ(drawn.code, kSuccess) << drawn.err;
  EXPECT_TRUE(drawn.out.starts_with("flowchart TB\n  subgraph kidnapped_machine[\"kidnapped\"]\n")) << drawn.out;
  for (const char* line : {"  subgraph head_scan_machine[\"head_scan\"]\n",
                           "  goal_search_searching -.->|\"pose_is_searched\"| penalty_marks_waiting\n",
                           "  penalty_marks_on_the_mark -.->|\"state\"| kidnapped_elsewhere_lost\n"})
    EXPECT_NE(drawn.out.find(line), std::string::npos) << line << drawn.out;
  EXPECT_EQ(run({"graph", "orientation", "--with-behaviors"}).code, kBadInput);
}

TEST_F(CommandsTest, GraphDrawsSeveralScriptsInOnePicture) {
  const ProgramRun drawn = run({"graph", "goal_search", "penalty_marks", "goal_search"});
  EXPECT_EQ(drawn.code, kSuccess) << drawn.err;
  EXPECT_NE(drawn.out.find("  goal_search_searching -.->|\"pose_is_searched\"| penalty_marks_waiting\n"),
            std::string::npos)
      << drawn.out;
  EXPECT_EQ(drawn.out.find("  subgraph goal_search_machine"), drawn.out.rfind("  subgraph goal_search_machine"));
  EXPECT_TRUE(run({"graph", "goal_search", "goal_search"}).out.starts_with("stateDiagram-v2\n"));
  EXPECT_TRUE(run({"graph", "goal_search", "get_up", "--format", "dot"}).out.starts_with("digraph machines {\n"));
}

TEST_F(CommandsTest, GraphRefusesANameOfTwoScripts) {
  std::ofstream(scripts_ / "scenarios/orientation.lua") << "scenario \"other\" { state \"here\" {} }\n";
  const ProgramRun drawn = run({"graph", "orientation"});
  EXPECT_EQ(drawn.code, kBadInput);
  EXPECT_NE(drawn.err.find("'orientation': expected one script, found behaviors/orientation.lua and "
                           "scenarios/orientation.lua; name the file"),
            std::string::npos)
      << drawn.err;
  EXPECT_NE(run({"graph", "scenarios/orientation.lua"}).out.find("here"), std::string::npos);
  EXPECT_EQ(run({"graph", "paper/paper_training"}).out, run({"graph", "paper_training"}).out);
}

TEST_F(CommandsTest, GraphWritesAFile) {
  EXPECT_EQ(run({"graph", "orientation", "--out", path("o.mmd")}).out, "");
  EXPECT_EQ(read_input(path("o.mmd"), "a file"), run({"graph", "orientation"}).out);
}

TEST_F(CommandsTest, GraphRefusesUnknownScripts) {
  const ProgramRun drawn = run({"graph", "orientatoin"});
  EXPECT_EQ(drawn.code, kBadInput);
  EXPECT_NE(drawn.err.find("(did you mean 'orientation'?)"), std::string::npos) << drawn.err;
  EXPECT_EQ(run({"graph", "orientation", "--format", "png"}).code, kBadInput);
}

TEST_F(CommandsTest, ReferenceContainsTheLibrariesOfTheUser) {
  std::ofstream(scripts_ / "lib/mine.lua")
      << "--- Mine.\n\nlocal mine = {}\n\n--- Blinks.\n---@param times number how often\n"
         "function mine.blink(times) end\n\nreturn mine\n";
  const ProgramRun page = run({"reference"});
  EXPECT_EQ(page.code, kSuccess) << page.err;
  EXPECT_TRUE(page.out.starts_with("# Script reference\n"));
  EXPECT_NE(page.out.find("| `blink(times)` | `times: number` how often |  | Blinks. |\n"), std::string::npos);
  EXPECT_EQ(run({"reference", "--format", "annotations", "--out", path("a.lua")}).out, "");
  EXPECT_NE(read_input(path("a.lua"), "a file").find("function library.blink(times) end\n"), std::string::npos);
  EXPECT_EQ(run({"reference", "--format", "html"}).code, kBadInput);
}

TEST_F(CommandsTest, ReferenceOfAnInterfaceIsAPageOrAnnotations) {
  const ProgramRun page = run({"reference", "--interface", "ball"});
  EXPECT_EQ(page.code, kSuccess) << page.err;
  EXPECT_TRUE(page.out.starts_with("# The interface `ball`\n")) << page.out;
  const ProgramRun annotations = run({"reference", "--interface", "ball", "--format", "annotations"});
  EXPECT_TRUE(annotations.out.starts_with("---@meta\n")) << annotations.out;
  const ProgramRun unknown = run({"reference", "--interface", "bal"});
  EXPECT_EQ(unknown.code, kBadInput);
  EXPECT_NE(unknown.err.find("unknown interface 'bal' (did you mean 'ball"), std::string::npos) << unknown.err;
}

TEST(MissingInterface, IsAWarningAtTheStartOfARun) {
  const TemporaryFolder folder;
  std::vector<std::string> words{"run", "--with", "kick_ball", "--seconds", "0.1", "--width", "160", "--no-pictures"};
  ChildProgram without(folder.path(), words);
  without.wait();
  EXPECT_NE(without.err().find("are missing; the interface 'ball' has them: --interface ball"), std::string::npos)
      << without.err();
  words.insert(words.end(), {"--interface", "ball"});
  ChildProgram with(folder.path(), words);
  with.wait();
  EXPECT_EQ(with.err().find("are missing"), std::string::npos) << with.err();
}

TEST_F(CommandsTest, NewBehaviorPassesItsCheckAndItsTest) {
  ASSERT_EQ(run({"new", "behavior", "ball_search"}).code, kSuccess);
  const ProgramRun checked = run({"check", "--strict"});
  EXPECT_EQ(checked.code, kSuccess) << checked.out;
  const ProgramRun tested = run({"test", (scripts_ / "tests/ball_search_test.lua").string()});
  EXPECT_EQ(tested.code, kSuccess) << tested.out;
  EXPECT_NE(tested.out.find("4 passed, 0 failed"), std::string::npos) << tested.out;
}

TEST_F(CommandsTest, NewScenarioPassesItsCheckAndItsTestOnTheSimulatorToo) {
  ASSERT_EQ(run({"new", "scenario", "wait_here"}).code, kSuccess);
  EXPECT_EQ(run({"check", "--strict"}).code, kSuccess);
  const ProgramRun tested = run({"test", "--simulator", (scripts_ / "tests/wait_here_test.lua").string()});
  EXPECT_EQ(tested.code, kSuccess) << tested.out;
  EXPECT_NE(tested.out.find("3 passed, 0 failed"), std::string::npos) << tested.out;
}

TEST_F(CommandsTest, NewNeverOverwritesAndAcceptsOnlyPlainNames) {
  const std::string before = read_input(scripts_ / "behaviors/orientation.lua", "a file");
  for (const char* name : {"orientation", "../escape", "Big", "with space", "", "1st", "a/b"}) {
    EXPECT_EQ(run({"new", "behavior", name}).code, kBadInput) << name;
  }
  EXPECT_EQ(run({"new", "robot", "x"}).code, kBadInput);
  EXPECT_EQ(read_input(scripts_ / "behaviors/orientation.lua", "a file"), before);
}

TEST_F(CommandsTest, ParamsListsValueOriginRangeAndMeaning) {
  const ProgramRun listed = run({"params", "orientation.", "--set", "orientation.lingering=0.3"});
  EXPECT_EQ(listed.code, kSuccess) << listed.err;
  EXPECT_NE(
      listed.out.find("  0.3  command line  0 to 1: fraction of particles near the mirrored pose that causes a purge"),
      std::string::npos)
      << listed.out;
  EXPECT_NE(listed.out.find("  0.2  default       0 to 10 s: time for which the evidence must exceed the threshold"),
            std::string::npos)
      << listed.out;
  EXPECT_EQ(listed.out.find("head_scan"), std::string::npos);
}

TEST_F(CommandsTest, ParamsListsParametersOfTheCoreTheSimulatorAndTheScenarios) {
  const ProgramRun listed = run({"params"});
  for (const char* name : {"pose_filter.", "room_status.", "posture.", "arbiter.flip_cooldown", "body.",
                           "script.max_memory", "mirrored_placement.learn", "walk.speed", "tile_row_compass."})
    EXPECT_NE(("\n" + listed.out).find(std::string("\n") + name), std::string::npos) << name;
}

TEST_F(CommandsTest, ParamsSendsNoControlCharactersToATerminal) {
  std::ofstream(scripts_ / "behaviors/odd.lua") << "param { x = { 1, range = { 0, 2 }, unit = \"m\\27[1m\", doc = "
                                                   "\"how\\nodd\\27[2J \\xFF\" } }\nbehavior \"odd\" {}\n";
  const ProgramRun listed = run({"params", "odd."});
  EXPECT_EQ(listed.code, kSuccess) << listed.err;
  EXPECT_NE(listed.out.find("0 to 2 m\\x1B[1m: how odd\\x1B[2J \\xFF\n"), std::string::npos) << listed.out;
}

TEST_F(CommandsTest, ParamsSavesOverridesThatARunLoads) {
  const std::string file = path("tuned.toml");
  ASSERT_EQ(run({"params", "--changed", "--set", "orientation.lingering=0.3", "--set",
                 "histogram_distance.measure=ssd3", "--save-params", file})
                .code,
            kSuccess)
      << run({"params", "orientation"}).out;
  const ProgramRun again = run({"params", "--changed", "--params", file});
  EXPECT_NE(again.out.find("orientation.lingering  "), std::string::npos) << again.out;
  EXPECT_NE(again.out.find("file"), std::string::npos) << again.out;
}

TEST_F(CommandsTest, ParamsAcceptsPresetsByName) {
  const ProgramRun paper = run({"params", "--changed", "--params", "paper"});
  EXPECT_EQ(paper.code, kSuccess) << paper.err;
  for (const char* changed :
       {"light_adaptation.enabled", "color.blur", "histogram_distance.measure", "view_filter.sharpness",
        "confidence.restart_on_purge", "background_model.true_mean_start"})
    EXPECT_NE(paper.out.find(changed), std::string::npos) << changed;
  EXPECT_EQ(run({"params", "--params", "papre"}).code, kBadInput);
}

TEST_F(CommandsTest, ParamsListsAGroupByItsNameWithADot) {
  const std::string group = run({"params", "orientation."}).out, part = run({"params", "orientation"}).out;
  EXPECT_TRUE(group.starts_with("orientation.")) << group;
  EXPECT_EQ(group.find("paper_orientation."), std::string::npos) << group;
  EXPECT_NE(part.find("paper_orientation."), std::string::npos) << part;
  EXPECT_NE(run({"params", "field_features."}).out.find("field_features."), std::string::npos);
}

TEST_F(CommandsTest, ParamsRefusesUnknownNamesAndValuesOutOfRange) {
  EXPECT_EQ(run({"params", "no_such_part"}).code, kBadInput);
  EXPECT_NE(run({"params", "orientaton."})
                .err.find("expected a part of a parameter's name, found 'orientaton.' (did you mean 'orientation.'?)"),
            std::string::npos);
  EXPECT_NE(
      run({"params", "lingring"})
          .err.find("expected a part of a parameter's name, found 'lingring' (did you mean 'orientation.lingering'?)"),
      std::string::npos);
  EXPECT_EQ(run({"params", "--set", "orientation.led=1"}).code, kBadInput);
  EXPECT_EQ(run({"params", "--set", "orientation.lingering=2"}).code, kBadInput);
}

TEST_F(CommandsTest, ARunSavesChangedParameters) {
  const std::string file = path("tuned.toml");
  run_shortly({"--scripts", scripts_.string(), "--set", "head_scan.speed=2.5", "--save-params", file});
  const std::string saved = read_input(file, "a file");
  EXPECT_EQ(saved.substr(0, saved.find(' ')), "head_scan.speed");
  EXPECT_EQ(run_shortly({"--save-params", path("no/folder/x")}).code, kBadInput);
}

TEST_F(CommandsTest, OneFileOfParametersServesARobotInAllItsScenarios) {
  const std::string team = path("team.toml"), saved = path("saved.toml");
  folder_.write("team.toml", "[mirrored_placement]\nlearn = 30\n[kidnapped]\nlearn = 20\n[careful]\nname = \"0\"\n");
  std::ofstream(scripts_ / "behaviors/careful.lua") << "behavior \"careful\" {}\n";
  const ProgramRun ran = run_shortly({"--scripts", scripts_.string(), "--params", team, "--save-params", saved});
  EXPECT_EQ(ran.code, kWrong) << ran.err;  // after three seconds
  const std::string text = read_input(saved, "a file");
  EXPECT_NE(text.find("mirrored_placement.learn = 30 "), std::string::npos) << text;
  EXPECT_NE(text.find("kidnapped.learn = 20  # not used in the run that saved this\n"), std::string::npos) << text;
  EXPECT_NE(text.find("careful.name = 0 "), std::string::npos) << text;
  // The saved file can be used for the other scenario, where a misspelled name is still an error.
  EXPECT_EQ(run_shortly({"kidnapped", "--scripts", scripts_.string(), "--params", saved}).code, kWrong);
  folder_.write("team.toml", "[kidnapped]\nleran = 20\n");
  EXPECT_EQ(run_shortly({"--scripts", scripts_.string(), "--params", team}).code, kWrong);
  const ProgramRun misspelt = run_shortly({"kidnapped", "--scripts", scripts_.string(), "--params", team});
  EXPECT_EQ(misspelt.code, kBadInput);
  EXPECT_NE(misspelt.err.find("team.toml:2: unknown parameter 'kidnapped.leran'"), std::string::npos) << misspelt.err;
  EXPECT_NE(misspelt.err.find("did you mean 'kidnapped.learn'?"), std::string::npos) << misspelt.err;
}

TEST_F(CommandsTest, ALoadedModuleWithoutParametersAcceptsNone) {
  std::ofstream(scripts_ / "behaviors/careful.lua") << "behavior \"careful\" {}\n";
  folder_.write("team.toml", "[careful]\nlead = 1\n");
  const std::vector<std::string> words{"--scripts", scripts_.string(), "--params", path("team.toml")};
  EXPECT_EQ(run_shortly(words).code, kWrong);
  std::vector<std::string> with = words;
  with.insert(with.end(), {"--with", "careful"});
  EXPECT_EQ(run_shortly(with).code, kBadInput);
}

TEST_F(CommandsTest, EndsSoonWithThousandsOfUnknownParameters) {
  std::string strangers, misspelt = "[head_scan]\n";
  for (int i = 0; i < 9'000; ++i) {
    strangers += "[stranger" + std::to_string(i) + "]\nkey = 1\n";
    misspelt += "key" + std::to_string(i) + " = 1\n";
  }
  folder_.write("strangers.toml", strangers);
  folder_.write("misspelt.toml", misspelt);
  EXPECT_EQ(run({"params", "--params", path("strangers.toml")}).code, kSuccess);
  EXPECT_EQ(run({"params", "--params", path("misspelt.toml")}).code, kBadInput);
}

TEST_F(CommandsTest, AScenarioChoosesItsRoomUnlessTheCommandLineDoes) {
  const std::string scenario =
      R"(scenario "elsewhere" { behaviors = { "head_scan" }, WHERE initial = "a", state "a" {} })";
  const auto write = [&](const std::string& where) {
    std::string text = scenario;
    text.replace(text.find("WHERE"), 5, where);
    folder_.write("scripts/scenarios/elsewhere.lua", text);
  };
  const auto digest = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"elsewhere", "--scripts", scripts_.string()};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramRun ran = run_shortly(words);
    EXPECT_EQ(ran.code, kWrong) << ran.err;
    return ran.out.substr(std::min(ran.out.find("digest: "), ran.out.size()));
  };
  write("");
  const std::string first = digest({}), second = digest({"--hall-seed", "2"});
  EXPECT_NE(first, second);
  write("hall_seed = 2, field = \"fields/mine.toml\",");
  std::filesystem::create_directory(scripts_ / "fields");
  std::filesystem::copy(kProjectFolder / "assets/fields/spl.toml", scripts_ / "fields/mine.toml");
  EXPECT_EQ(digest({}), second);
  EXPECT_EQ(digest({"--hall-seed", "1"}), first);
  write("room = \"rooms/gone.hdr\",");
  const ProgramRun refused = run_shortly({"elsewhere", "--scripts", scripts_.string()});
  EXPECT_EQ(refused.code, kBadInput);
  EXPECT_NE(refused.err.find("scripts/rooms/gone.hdr'"), std::string::npos) << refused.err;
  write("room = \"rooms/gone.hdr\", hall_seed = 2,");
  EXPECT_NE(
      run_shortly({"elsewhere", "--scripts", scripts_.string()}).err.find("expected a room or a hall_seed, found both"),
      std::string::npos);
}

TEST_F(CommandsTest, ASimulatedTestChoosesItsRoom) {
  const auto result = [&](const std::string& where) {
    folder_.write(
        "scripts/tests/place_test.lua",
        "test(\"a\", function() simulate { scenario = \"mirrored_placement\", seconds = 0.1, " + where + " } end)");
    return run({"test", "--simulator", (scripts_ / "tests/place_test.lua").string()});
  };
  EXPECT_EQ(result("hall_seed = 2, field = \"spl\"").code, kSuccess);
  EXPECT_NE(result("room = \"gone.hdr\"").out.find("unknown room '"), std::string::npos);
  EXPECT_NE(result("room = \"hall\"").out.find("unknown room '"), std::string::npos);
  EXPECT_NE(result("hall_seed = -1").out.find("hall_seed: expected a non-negative whole number"), std::string::npos);
  EXPECT_NE(result("room = \"a.hdr\", hall_seed = 1").out.find("found both"), std::string::npos);
}

TEST_F(CommandsTest, ATestReadsNoFileOutsideOfTheScripts) {
  const std::string outside = folder_.write("outside.toml", "").string(),
                    script = folder_.write("own.lua", "").string();
  std::filesystem::create_directories(scripts_ / "fields");
  std::filesystem::create_symlink(outside, scripts_ / "fields/link.toml");
  const auto refusal = [&](const std::string& scenario, const std::string& more) {
    folder_.write("scripts/tests/place_test.lua", "test(\"a\", function() simulate { scenario = \"" + scenario +
                                                      "\", seconds = 0.1, " + more + " } end)");
    const ProgramRun result = run({"test", "--simulator", (scripts_ / "tests/place_test.lua").string()});
    EXPECT_EQ(result.code, kWrong) << more;
    return result.out;
  };
  const std::string absent = (folder_.path() / "absent").string();
  for (const std::string& file :
       {outside, absent + ".toml", absent, std::string("../outside.toml"), std::string("../absent.toml"),
        std::string("a/../../outside"), std::string("fields/link.toml")}) {
    for (const char* what : {"room", "field"}) {
      const std::string why = fmt::format(
          "{} of a script: expected a file below the root of the scripts, or the name of a shipped one, found '{}'",
          what, file);
      const std::string setting = fmt::format("{} = \"{}\"", what, file);
      EXPECT_NE(refusal("mirrored_placement", setting).find(why), std::string::npos) << file;
      folder_.write(
          "scripts/scenarios/elsewhere.lua",
          fmt::format(R"(scenario "elsewhere" {{ behaviors = {{}}, {}, initial = "a", state "a" {{}} }})", setting));
      EXPECT_NE(refusal("elsewhere", "").find(why), std::string::npos) << file;
    }
  }
  for (const std::string& file : {script, absent + ".lua", absent, outside}) {
    const std::string why = "simulate: expected a script below the root of the scripts, found '" + file + "'";
    EXPECT_NE(refusal(file, "").find(why), std::string::npos) << file;
    EXPECT_NE(refusal("mirrored_placement", "with = { \"" + file + "\" }").find(why), std::string::npos) << file;
  }
}

TEST_F(CommandsTest, AScenarioMayNameAShippedFileByItsPath) {
  const auto shipped = kProjectFolder / "assets/fields/spl.toml";
  folder_.write("scripts/scenarios/elsewhere.lua", "scenario \"elsewhere\" { behaviors = {}, field = \"" +
                                                       shipped.string() + "\", initial = \"a\", state \"a\" {} }");
  const ProgramRun ran = run_shortly({"elsewhere", "--scripts", scripts_.string()});
  EXPECT_NE(ran.out.find("digest: "), std::string::npos) << ran.err;
}

/// All keys of an object, and those of the objects in it.
std::set<std::string> keys_of(const nlohmann::json& json) {
  std::set<std::string> keys;
  for (const auto& [key, value] : json.items()) {
    if (json.is_object()) keys.insert(key);
    if (value.is_structured()) keys.merge(keys_of(value));
  }
  return keys;
}

TEST_F(CommandsTest, SetTakesNameAndValueAsThePromptDoes) {
  const std::string joined = run({"params", "wall.radius", "--set", "wall.radius=7.5"}).out;
  EXPECT_NE(joined.find("7.5  command line"), std::string::npos) << joined;
  EXPECT_EQ(run({"params", "wall.radius", "--set", "wall.radius", "7.5"}).out, joined);
  EXPECT_EQ(run({"params", "--set", "wall.radius", "7.5", "wall.radius"}).out, joined);
  EXPECT_EQ(run({"params", "wall.radius", "--set", "wall.radius"}).code, kBadInput);
  EXPECT_EQ(run({"params", "--set", "wall.radius", "--changed"}).code, kBadInput);
}

TEST_F(CommandsTest, EachKeyOfTheSummaryIsDocumented) {
  const std::string file = path("run.json");
  run({"run", "--seconds", "3", "--width", "160", "--no-pictures", "--json", file});
  const std::string page = read_input(kProjectFolder / "docs/run-summary.md", "a file");
  const std::string source = read_input(kProjectFolder / "program/run/report.cpp", "a file");
  const std::set<std::string> written = keys_of(nlohmann::json::parse(read_input(file, "a file")));
  EXPECT_GE(written.size(), 40U);
  for (const std::string& key : written) EXPECT_NE(page.find("`" + key + "`"), std::string::npos) << key;
  std::istringstream rows(page);
  for (std::string row; std::getline(rows, row);) {
    if (!row.starts_with("| `")) continue;
    for (std::size_t begin = row.find('`'); begin != std::string::npos; begin = row.find('`', begin)) {
      const std::string key = row.substr(begin + 1, row.find('`', begin + 1) - begin - 1);
      begin += key.size() + 2;
      EXPECT_TRUE(key.starts_with("--") || source.find("\"" + key + "\"") != std::string::npos)
          << "documented, but not written: " << key;
    }
  }
}

TEST_F(CommandsTest, TestWritesAReportAndCoverage) {
  const std::string file = path("report.xml");
  const ProgramRun tested = run({"test", "--coverage", "--junit", file, (scripts_ / "tests/get_up_test.lua").string()});
  EXPECT_EQ(tested.code, kSuccess) << tested.out;
  EXPECT_NE(tested.out.find("get_up: 3 of 3 states"), std::string::npos) << tested.out;
  EXPECT_TRUE(read_input(file, "a file").starts_with("<?xml"));
  EXPECT_EQ(run({"test", "--junit", path("no/folder/x")}).code, kBadInput);
}

TEST_F(CommandsTest, TestPrintsTheCoverageAlsoIfTheReportCannotBeWritten) {
  const ProgramRun tested =
      run({"test", "--coverage", "--junit", "/dev/full", (scripts_ / "tests/get_up_test.lua").string()});
  EXPECT_EQ(tested.code, kBadInput);
  EXPECT_NE(tested.out.find("get_up: 3 of 3 states"), std::string::npos) << tested.out;
  EXPECT_NE(tested.out.find("\ntotal: "), std::string::npos) << tested.out;
  EXPECT_EQ(tested.err, "reorient: cannot write '/dev/full': No space left on device\n");
}

TEST(ShippedScripts, PassTheirOwnTestsOnTheSimulatorToo) {
  const ProgramRun tested = run_reorient(patiently({"test", "--simulator"}));
  EXPECT_EQ(tested.code, kSuccess) << tested.out;
  EXPECT_NE(tested.out.find(" passed, 0 failed\n"), std::string::npos) << tested.out;
}

}  // namespace
}  // namespace reorient

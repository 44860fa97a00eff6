// SPDX-License-Identifier: MIT
// The prompt during a run.
#include "program/run/console/live_console.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/engine/frame_fixture.h"
#include "tests/temporary_folder.h"
#include "tests/waiting.h"
#include "workbench/files/parameter_file.h"
#include "workbench/files/script_files.h"

namespace reorient {
namespace {

constexpr const char* kLamp = R"(param { level = { 0.5, range = { 0, 1 }, unit = "m", doc = "how bright" } }
behavior "tested" {
  initial = "off",
  state "off" {
    { "on", when = function() return robot.penalized end, lasting = 0.5, because = "it is dark" },
    { "on", after = 3600 },
  },
  state "on" {},
})";
constexpr const char* kScene = R"(param { pace = { 1, range = { 0, 2 }, doc = "how fast" } }
scenario "scene" { behaviors = {}, initial = "waiting", state "waiting" { { "over", after = 3600 } }, state "over" {} })";

class LiveConsoleTest : public ::testing::Test {
 protected:
  LiveConsoleTest() {
    if (pipe(ends_) != 0) ADD_FAILURE() << "no pipe";
    ScriptTexts texts;
    texts.apply({"scenarios/scene.lua", ScriptText{kScene, ""}});
    scenario.emplace(texts, "scene", std::vector<ParameterChange>{}, no_behaviors_);
    folder.write("behaviors/tested.lua", kLamp);
    folder.write("scenarios/scene.lua", kScene);
    const auto parameters = [this] {
      std::vector<Parameter> all = loop.engine->parameters();
      for (const Parameter& parameter : scenario->parameters().list()) all.push_back(parameter);
      return all;
    };
    console.emplace(ends_[0], out_,
                    ConsoleSubject{.scenario = &*scenario,
                                   .parameters = parameters,
                                   .scripts = [this] { return &(on_disk = read_scripts(folder.path())); },
                                   .engine = [this] { return &*loop.engine; }});
    poll();
  }
  ~LiveConsoleTest() override {
    close(ends_[0]);
    close_writing();
  }

  void close_writing() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }
  void type(const std::string& text) const {
    ASSERT_EQ(write(ends_[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  /// The output of the console in one frame.
  std::string poll() {
    out_.str("");
    console->add_to(loop.inputs);
    loop.wanted = console->wanted();
    if (!loop.inputs.script_edits.empty()) scenario->apply(loop.inputs.script_edits);
    const FrameRecord& frame = loop.step();
    scene_.scenario = scenario->tick({frame.world, frame.application, std::nullopt});
    console->observe(loop.record(), scene_);
    return out_.str();
  }
  std::string answer(const std::string& line) {
    type(line + "\n");
    return poll();
  }
  /// The same for a command whose answer may come some frames later.
  std::string late_answer(const std::string& line) {
    std::string text = answer(line);
    await([&] {
      if (text.empty()) text = poll();
      return !text.empty();
    });
    return text;
  }
  std::string printed() const { return out_.str().substr(out_.str().rfind('\n', out_.str().size() - 2) + 1); }
  /// The output in this many frames.
  std::string polls(int frames) {
    std::string said;
    for (int i = 0; i < frames; ++i) said += poll();
    return said;
  }
  Parameter parameter(const std::string& name) {
    for (const Parameter& one : loop.engine->parameters()) {
      if (one.name == name) return one;
    }
    ADD_FAILURE() << "unknown parameter " << name;
    return {};
  }
  double level() { return std::get<double>(parameter("tested.level").value); }

  TemporaryFolder folder;
  HandFedLoop loop{kLamp};
  std::optional<ScenarioHost> scenario;
  ScriptTexts on_disk;
  std::optional<LiveConsole> console;

 private:
  RecordedBehaviors no_behaviors_;
  SceneTruth scene_;
  std::ostringstream out_;
  int ends_[2] = {-1, -1};
};

TEST_F(LiveConsoleTest, SetsAParameter) {
  EXPECT_EQ(answer("set tested.level 0.75"), "  tested.level = 0.75\n");
  EXPECT_EQ(level(), 0.75);
  EXPECT_EQ(parameter("tested.level").origin, ParameterOrigin::live);
}

TEST_F(LiveConsoleTest, SetsAParameterInTheFormOfTheCommandLine) {
  EXPECT_EQ(answer("set tested.level=0.75"), "  tested.level = 0.75\n");
  EXPECT_EQ(level(), 0.75);
  EXPECT_NE(answer("set =1").find("unknown parameter ''"), std::string::npos);
  EXPECT_NE(answer("set tested.level=").find("0 to 1"), std::string::npos);
  EXPECT_NE(answer("set tested.level==1").find("0 to 1"), std::string::npos);
  EXPECT_EQ(level(), 0.75);
}

TEST_F(LiveConsoleTest, ExecutesOnlyQuitWithoutARobot) {
  type("states\nquit\n");
  console->poll_without_robot();
  EXPECT_FALSE(console->wants_to_quit());
  EXPECT_EQ(printed(), "  expected quit, found 'states'; other commands need a connected client\n");
  console->poll_without_robot();
  EXPECT_TRUE(console->wants_to_quit());
}

TEST_F(LiveConsoleTest, ReportsErrorsAndChangesNothing) {
  EXPECT_NE(answer("set tested.level 7").find("0 to 1"), std::string::npos);
  EXPECT_NE(answer("set tested.levle 0.7").find("tested.level"), std::string::npos);
  EXPECT_NE(answer("set tested.level").find("set NAME VALUE"), std::string::npos);
  EXPECT_NE(answer("sett tested.level 1").find("did you mean 'set'"), std::string::npos);
  EXPECT_NE(late_answer("save /no/such/folder/file").find("cannot write"), std::string::npos);
  EXPECT_EQ(answer("states now"), "  expected states\n");
  EXPECT_EQ(level(), 0.5);
}

TEST_F(LiveConsoleTest, ListsParametersAndStates) {
  answer("set tested.level 0.25");
  EXPECT_EQ(answer("params tested"), "  tested.level = 0.25  (0 to 1 m; live) how bright\n");
  EXPECT_NE(answer("params nothing").find("unknown parameter 'nothing'"), std::string::npos);
  EXPECT_NE(answer("states").find("tested"), std::string::npos);
  EXPECT_NE(answer("help").find("save FILE"), std::string::npos);
}

TEST_F(LiveConsoleTest, SavesChangedParameters) {
  answer("set tested.level 0.25");
  const std::filesystem::path file = folder.path() / "tuned.toml";
  EXPECT_NE(late_answer("save " + file.string()).find("written"), std::string::npos);
  EXPECT_NE(late_answer("save " + folder.path().string())
                .find("expected a file, found a folder; name another file with save"),
            std::string::npos);
  FrameSetup setup;
  setup.parameters = read_parameters(file);
  HandFedLoop again(kLamp, std::move(setup));
  for (const Parameter& one : again.engine->parameters()) {
    if (one.name == "tested.level") {
      EXPECT_EQ(std::get<double>(one.value), 0.25);
    }
  }
}

TEST_F(LiveConsoleTest, SetsWhatTheScenarioDeclaresToo) {
  EXPECT_EQ(answer("set scene.pace 2"), "  scene.pace = 2\n");
  EXPECT_EQ(std::get<double>(scenario->parameters().value("scene.pace")), 2.0);
  EXPECT_NE(answer("set scene.pace 3").find("0 to 2"), std::string::npos);
  EXPECT_NE(answer("states").find("scene"), std::string::npos);
}

TEST_F(LiveConsoleTest, NeverWaitsForALine) {
  EXPECT_EQ(poll(), "");
  type("set tested.le");
  EXPECT_EQ(poll(), "");
  type("vel 1\r\nset tested");
  EXPECT_EQ(poll(), "  tested.level = 1\n");
  type(".level 0\n");
  EXPECT_EQ(poll(), "  tested.level = 0\n");
}

TEST_F(LiveConsoleTest, OpensAPromptOnAnEmptyLineAndClosesItOnTheNext) {
  type("\n");
  EXPECT_EQ(poll(), "> ");
  EXPECT_TRUE(console->is_open());
  type("set tested.level 1\n");
  EXPECT_EQ(poll(), "set tested.level 1\n  tested.level = 1\n> ") << "a pipe does not echo the input";
  type("\n");
  EXPECT_EQ(poll(), "\n");
  EXPECT_FALSE(console->is_open());
}

TEST_F(LiveConsoleTest, ContinuesAtTheEndOfTheInput) {
  type("set tested.level 1");
  close_writing();
  EXPECT_EQ(polls(2), "  tested.level = 1\n") << "the last line needs no line break";
  EXPECT_EQ(poll(), "");
  EXPECT_EQ(poll(), "");
  EXPECT_FALSE(console->wants_to_quit());
}

TEST_F(LiveConsoleTest, EndsTheRunWhenAsked) {
  type("quit\nset tested.level 1\n");
  poll();
  EXPECT_TRUE(console->wants_to_quit());
}

TEST_F(LiveConsoleTest, DropsALineThatHasNoEnd) {
  std::string said;
  for (int i = 0; i < 10; ++i) {
    type(std::string(3000, 'x'));
    said += poll();
  }
  EXPECT_EQ(said, "");
  type("\nset tested.level 1\n");
  EXPECT_EQ(polls(2), "  expected a line of at most 1000 bytes, found a longer one\n  tested.level = 1\n");
}

TEST_F(LiveConsoleTest, TakesOneCommandAFrame) {
  std::string many;
  for (int i = 0; i < 1000; ++i) many += i % 2 == 0 ? "set tested.level 1\n" : "set tested.level 0\n";
  type(many);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(poll(), i % 2 == 0 ? "  tested.level = 1\n" : "  tested.level = 0\n");
    EXPECT_EQ(loop.record().parameter_changes.size(), 1u);
  }
}

TEST_F(LiveConsoleTest, SurvivesBytesThatAreNotText) {
  type(std::string("set \0 1\n", 8));
  EXPECT_EQ(poll(), "  expected text, found a line with zero bytes\n");
  EXPECT_EQ(answer("set \x80\xFF 1"), "  unknown parameter '\\x80\\xFF'\n");
  EXPECT_EQ(answer("\x1B[2J\a"), "  unknown command '\\x1B[2J\\x07'; help lists them\n");
  const std::string said = answer(std::string(900, '\xC3'));
  EXPECT_LT(said.size(), 320u);
}

// ---- parameters

TEST_F(LiveConsoleTest, UndoesChangesOneByOne) {
  EXPECT_EQ(answer("undo"), "  no change to undo\n");
  answer("set tested.level 0.25");
  answer("set scene.pace 2");
  answer("set tested.level 7");  // refused, so it cannot be undone
  answer("set tested.level 0.75");
  EXPECT_EQ(answer("undo"), "  tested.level = 0.25\n");
  EXPECT_EQ(answer("undo"), "  scene.pace = 1\n");
  EXPECT_EQ(std::get<double>(scenario->parameters().value("scene.pace")), 1.0);
  EXPECT_EQ(answer("undo"), "  tested.level = 0.5\n");
  EXPECT_EQ(level(), 0.5);
  EXPECT_EQ(answer("diff"), "  all parameters have their defaults\n") << "none is set any more";
  EXPECT_EQ(answer("undo"), "  no change to undo\n");
}

TEST_F(LiveConsoleTest, ListsParametersThatDifferFromTheDefaults) {
  EXPECT_EQ(answer("diff"), "  all parameters have their defaults\n");
  answer("set tested.level 0.25");
  answer("set scene.pace 2");
  EXPECT_EQ(answer("diff"), "  tested.level = 0.25  (default 0.5; live)\n  scene.pace = 2  (default 1; live)\n");
  answer("set tested.level 0.5");
  EXPECT_EQ(answer("diff"), "  scene.pace = 2  (default 1; live)\n");
  const std::filesystem::path file = folder.path() / "tuned.toml";
  late_answer("save " + file.string());
  EXPECT_EQ(read_parameters(file).size(), 1u) << "a parameter that has its default again is not saved";
}

// ---- the world

TEST_F(LiveConsoleTest, ShowsTheWorldAsBehaviorsSeeIt) {
  EXPECT_EQ(answer("world robot.posture"), "  robot.posture = upright  (current posture of the robot)\n");
  EXPECT_EQ(answer("world pose.known").substr(0, 22), "  pose.known = false  ");
  EXPECT_EQ(answer("world *.step").substr(0, 24), "  clock.step = 0.033 s  ");
  const std::string pose = answer("world pose.*");
  EXPECT_NE(pose.find("  pose.rotation = "), std::string::npos) << pose;
  EXPECT_EQ(pose.find("posture"), std::string::npos);
  EXPECT_NE(answer("world").find("field.length"), std::string::npos);
  EXPECT_EQ(answer("world pose.z"), "  unknown world value 'pose.z' (did you mean 'pose.x'?)\n");
}

TEST_F(LiveConsoleTest, PrintsAWatchedValueWhenItChanges) {
  EXPECT_NE(answer("watch").find("no watched values"), std::string::npos);
  EXPECT_EQ(answer("watch robot.head_yaw"), "  0.07 s  robot.head_yaw = 0.000 rad\n");
  EXPECT_EQ(polls(30), "");
  loop.inputs.observation.body.head.yaw = 0.25;
  EXPECT_EQ(poll(), "  1.10 s  robot.head_yaw = 0.250 rad\n");
  loop.inputs.observation.body.head.yaw = 0.5;
  EXPECT_EQ(polls(14), "") << "not so soon again";
  EXPECT_EQ(polls(30), "  1.60 s  robot.head_yaw = 0.500 rad\n");
  EXPECT_EQ(answer("watch").substr(8), "  robot.head_yaw = 0.500 rad\n");
  EXPECT_EQ(answer("unwatch robot.posture"), "  unknown watched value 'robot.posture'\n");
  answer("watch robot.posture");
  answer("watch robot.head_pitch");
  EXPECT_EQ(answer("unwatch robot.posture"), "  2 values still watched\n");
  EXPECT_EQ(answer("unwatch robot.head_yaw"), "  1 value still watched\n");
  EXPECT_EQ(answer("unwatch"), "  no values watched\n");
  loop.inputs.observation.body.head.yaw = 0.0;
  EXPECT_EQ(polls(60), "");
}

TEST_F(LiveConsoleTest, PrintsEachWatchedValueAtMostTwiceASecond) {
  answer("watch clock.*");
  const std::string said = polls(60);
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 8) << said;  // time and frame; the step does not change
}

// ---- machines

TEST_F(LiveConsoleTest, ExplainsTheStateOfABehavior) {
  EXPECT_EQ(answer("why tested"),
            "  tested: off for 0.0 s\n"
            "    -> on  no, 0.0 of 0.5 s       it is dark (line 5)\n"
            "       robot.penalized = false\n"
            "    -> on  after 0.0 of 3600.0 s  after 3600 s (line 6)\n");
}

TEST_F(LiveConsoleTest, ShowsTheDwellTimeOfACondition) {
  loop.inputs.external.referee = RefereeState{.penalized = true};
  polls(7);
  EXPECT_NE(answer("why tested").find("-> on  yes, 0.2 of 0.5 s "), std::string::npos);
  polls(30);
  EXPECT_EQ(answer("why tested"), "  tested: on for 0.8 s\n    no transition leaves this state\n");
}

TEST_F(LiveConsoleTest, ExplainsTheStateOfTheScenario) {
  EXPECT_EQ(answer("why scene"),
            "  scene: waiting for 0.0 s\n    -> over  after 0.0 of 3600.0 s  after 3600 s (line 2)\n");
  EXPECT_EQ(answer("why tesetd"), "  unknown machine 'tesetd' (did you mean 'tested'?)\n");
}

TEST_F(LiveConsoleTest, DoesNotChangeTheRunByQueries) {
  HandFedLoop undisturbed(kLamp);
  std::vector<std::byte> mine, others;
  undisturbed.step(10);
  for (int i = 0; i < 9; ++i) answer(i % 3 == 0 ? "why tested" : i % 3 == 1 ? "world" : "states");
  loop.engine->save(mine);
  undisturbed.engine->save(others);
  EXPECT_EQ(mine, others);
}

TEST_F(LiveConsoleTest, ReloadsUnchangedScripts) {
  EXPECT_EQ(answer("reload tested"), "  behaviors/tested.lua was reloaded\n");
  EXPECT_EQ(answer("reload"), "  behaviors/tested.lua was reloaded\n  scenarios/scene.lua was reloaded\n");
  EXPECT_EQ(answer("reload tsted").substr(0, 23), "  unknown script 'tsted");
  folder.write("behaviors/tested.lua", "behavior \"broken");
  const std::string refused = answer("reload tested");
  EXPECT_NE(refused.find("refused; the previous version keeps running: behaviors/tested.lua:1"), std::string::npos)
      << refused;
  EXPECT_EQ(loop.record().machines.size(), 1u);
}

// ---- the prompt itself

TEST_F(LiveConsoleTest, RecordsANote) {
  EXPECT_NE(answer("note \"the referee  moved it\"").find("noted at"), std::string::npos);
  ASSERT_EQ(loop.record().logs.size(), 1u);
  EXPECT_EQ(loop.record().logs[0].text, "the referee moved it");
  EXPECT_TRUE(loop.record().logs[0].is_note);
  EXPECT_NE(answer("note").find("expected note TEXT..."), std::string::npos);
  poll();
  EXPECT_TRUE(loop.record().logs.empty()) << "it is noted once";
}

TEST_F(LiveConsoleTest, WaitsInTheRobotsTime) {
  type("wait 1\nset tested.level 1\n");
  EXPECT_EQ(polls(30), "");
  EXPECT_EQ(level(), 0.5);
  EXPECT_EQ(polls(2), "  tested.level = 1\n");
  EXPECT_NE(answer("wait long").find("number"), std::string::npos);
  EXPECT_NE(answer("wait -1").find("0 to 36000"), std::string::npos);
}

TEST_F(LiveConsoleTest, ListsItsCommands) {
  EXPECT_EQ(answer("help why"),
            "  why MACHINE           transitions of a behavior's state, and what their conditions lack\n");
  EXPECT_NE(answer("help wyh").find("did you mean 'why'"), std::string::npos);
  EXPECT_EQ(answer("undo all"), "  expected undo\n");
}

TEST_F(LiveConsoleTest, CompletesArgumentsOfCommands) {
  CommandTable table({.scenario = &*scenario,
                      .parameters = [this] { return loop.engine->parameters(); },
                      .scripts = [this] { return &(on_disk = read_scripts(folder.path())); }});
  loop.step();
  table.observe(loop.record(), SceneTruth());
  const auto offers = [&](const Words& before, const std::string& name) {
    const Words all = table.candidates(before);
    return std::find(all.begin(), all.end(), name) != all.end();
  };
  EXPECT_TRUE(offers({}, "why"));
  EXPECT_TRUE(offers({"help"}, "watch"));
  EXPECT_TRUE(offers({"set"}, "tested.level"));
  EXPECT_TRUE(offers({"set", "tested.level"}, "0.5"));
  EXPECT_TRUE(offers({"set", "light_adaptation.enabled"}, "false"));
  EXPECT_TRUE(offers({"set", "histogram_distance.measure"}, "hellinger"));
  EXPECT_TRUE(offers({"watch"}, "confidence.current"));
  EXPECT_TRUE(offers({"why"}, "tested"));
  EXPECT_TRUE(offers({"reload"}, "scene"));
  EXPECT_FALSE(offers({"why", "tested"}, "tested"));
  EXPECT_TRUE(table.candidates({"nonsense"}).empty());
}

}  // namespace
}  // namespace reorient

// SPDX-License-Identifier: MIT
// What `reorient check` finds without running a script, and where.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/script/script_texts.h"
#include "tests/temporary_folder.h"
#include "workbench/script_tools/check/missing_values.h"
#include "workbench/script_tools/check/script_check.h"

namespace reorient {
namespace {

class ScriptCheckTest : public ::testing::Test {
 protected:
  CheckResult check() { return check_scripts(folder.path(), {}); }
  /// All findings, one a line.
  std::string findings() {
    std::string text;
    for (const Finding& finding : check().findings) text += finding.text() + "\n";
    return text;
  }

  TemporaryFolder folder;
};

TEST_F(ScriptCheckTest, ReportsAllMistakesOfADeclarationWithLineAndColumn) {
  folder.write("behaviors/wrong.lua", R"(local p = param { proof = { 1, range = { 0, 2 }, doc = "x" } }
behavior "wrong" {
  initial = "watchin",
  state "watching" {
    { "gonig", when = function() return robot.penalized end, lasting = "prof" },
    { "going", when = 3 },
    entr = function() end,
  },
  state "going" {
    { "watching", after = -1 },
    { "watching" },
  },
}
)");
  EXPECT_EQ(findings(),
            R"(behaviors/wrong.lua:2:10: error: the machine: unknown initial state 'watchin' (did you mean 'watching'?)
behaviors/wrong.lua:5:7: error: state 'watching': unknown target state 'gonig' (did you mean 'going'?)
behaviors/wrong.lua:5:62: error: unknown param 'prof' (did you mean 'proof'?)
behaviors/wrong.lua:6:7: error: state 'watching' leads to 'going' without a condition: add 'when' or 'after'
behaviors/wrong.lua:6:16: error: when: expected a function, found a number
behaviors/wrong.lua:7:5: error: unknown key 'entr' (did you mean 'enter'?)
behaviors/wrong.lua:10:19: error: after: expected a non-negative number of seconds
behaviors/wrong.lua:11:7: error: state 'going' leads to 'watching' without a condition: add 'when' or 'after'
)");
}

TEST_F(ScriptCheckTest, ReportsMistakesOfParamsAtTheirNames) {
  folder.write("behaviors/wrong.lua", R"(param {
  outside = { 3, range = { 0, 2 }, doc = "x" },
  silent  = { 1, range = { 0, 2 } },
  open    = { 1, doc = "x" },
}
behavior "wrong" {}
)");
  const std::string found = findings();
  EXPECT_NE(found.find("wrong.lua:2:3: error: "), std::string::npos) << found;
  EXPECT_NE(found.find("wrong.lua:3:3: error: param silent: missing description"), std::string::npos) << found;
  EXPECT_NE(found.find("wrong.lua:4:3: error: param open: missing range"), std::string::npos) << found;
}

TEST_F(ScriptCheckTest, WarnsOfStatesThatAreNeverReachedOrNeverLeft) {
  folder.write("behaviors/odd.lua", R"(behavior "odd" {
  initial = "one",
  state "one" { { "two", after = 1 } },
  state "two" {},
  state "island" { { "one", after = 1 } },
}
)");
  EXPECT_EQ(findings(),
            "behaviors/odd.lua:4:9: warning: no transition leaves state 'two'\n"
            "behaviors/odd.lua:5:9: warning: state 'island' is never reached\n");
  EXPECT_EQ(check().count(Finding::Severity::error), 0);
}

TEST_F(ScriptCheckTest, WarnsOfAnInitialStateThatEveryTransitionBypasses) {
  folder.write("behaviors/odd.lua", R"(behavior "odd" {
  initial = "one",
  state "one" { { "two/late", after = 1 } },
  state "two" { initial = "early", { "one", after = 9 }, state "early" { { "late", after = 1 } }, state "late" {} },
}
)");
  EXPECT_EQ(findings(), "behaviors/odd.lua:4:64: warning: state 'two/early' is never reached\n");
}

TEST_F(ScriptCheckTest, WarnsOfAFormerName) {
  folder.write("behaviors/old.lua", R"(behavior "old" {
  initial = "one",
  state "one" { { "two", when = function() return confidence.asymmetry > 0.5 end } },
  state "two" { { "one", after = 1 } },
}
)");
  EXPECT_EQ(findings(),
            "behaviors/old.lua:3:62: warning: confidence.asymmetry is a former name: use confidence.separability\n");
}

TEST_F(ScriptCheckTest, WarnsIfTheNamesOfFileAndMachineDiffer) {
  folder.write("behaviors/near/second.lua", "\nbehavior \"first\" { state \"a\" {} }\n");
  folder.write("scenarios/evening.lua", "scenario \"morning\" { state \"a\" {} }\n");
  EXPECT_EQ(findings(),
            "behaviors/near/second.lua:2:10: warning: behavior 'first' is declared in a file with the name 'second' "
            "(expected the same name)\n"
            "scenarios/evening.lua:1:10: warning: scenario 'morning' is declared in a file with the name 'evening' "
            "(expected the same name)\n");
}

TEST_F(ScriptCheckTest, WarnsOfATransitionToItsParentState) {
  folder.write("behaviors/odd.lua", R"(behavior "odd" {
  initial = "outer",
  state "outer" {
    initial = "a",
    common = { { "outer", after = 5 } },
    state "a" { { "b", after = 1 } },
    state "b" { { "outer", after = 1 } },
  },
}
)");
  EXPECT_EQ(findings(),
            "behaviors/odd.lua:5:18: warning: the transition to 'outer' is never taken: 'outer' is already "
            "active (expected a target inside or outside of it)\n"
            "behaviors/odd.lua:7:11: warning: no transition leaves state 'outer/b'\n"
            "behaviors/odd.lua:7:19: warning: the transition to 'outer' is never taken: 'outer' is already "
            "active (expected a target inside or outside of it)\n");
}

TEST_F(ScriptCheckTest, AcceptsATransitionOfAStateToItself) {
  folder.write("behaviors/again.lua", R"(behavior "again" { initial = "a", state "a" { { "a", after = 1 } } })");
  EXPECT_EQ(findings(), "");
}

TEST_F(ScriptCheckTest, ChecksTheArgumentsOfLibraryFunctions) {
  folder.write("lib/steps.lua", R"(local steps = {}
function steps.clamp(value, most) return math.min(value, most) end
function steps.go(speed, how) if how then print(how) end walk.velocity(speed, 0, 0) end
return steps
)");
  folder.write("behaviors/b.lua", R"(local steps = require "lib.steps"
behavior "b" { update = function()
  steps.go(steps.clamp(1.0))
  steps.go("fast")
  if steps.clamp then print("always") end
  if robot.penalized and steps.clamp then print("whenever it is penalized") end
end }
)");
  EXPECT_EQ(
      findings(),
      "behaviors/b.lua:3:23: error: lib.steps.clamp: expected 2 arguments, found 1: lib.steps.clamp(value, most)\n"
      "behaviors/b.lua:4:12: error: argument 1 of lib.steps.go: expected a number, found a string\n"
      "behaviors/b.lua:5:6: warning: lib.steps.clamp is a function, which is always true: call it, "
      "lib.steps.clamp()\n"
      "behaviors/b.lua:6:26: warning: lib.steps.clamp is a function, which is always true: call it, "
      "lib.steps.clamp()\n");
}

TEST_F(ScriptCheckTest, RejectsKeysWithoutEffectForTheTypeOfAParameter) {
  folder.write("behaviors/odd.lua", R"(param {
  switch = { true, range = { 0, 1 }, doc = "x" },
  choice = { "a", choices = { "a" }, range = { 0, 1 }, doc = "x" },
  number = { 1, range = { 0, 1 }, choices = { "a" }, doc = "x" },
  whole  = { 0.5, range = { 0, 1 }, integer = true, doc = "x" },
  wide   = { 1, range = { 0, 1, 2 }, doc = "x" },
}
behavior "odd" { state "a" { history = "yes" } }
)");
  EXPECT_EQ(
      findings(),
      "behaviors/odd.lua:2:3: error: param switch is true or false: unexpected key 'range'\n"
      "behaviors/odd.lua:3:3: error: param choice has a string as default, so it is a choice: unexpected key 'range'\n"
      "behaviors/odd.lua:4:3: error: param number is a number: unexpected key 'choices'\n"
      "behaviors/odd.lua:5:3: error: param whole: expected a whole number as default\n"
      "behaviors/odd.lua:6:3: error: param wide: expected range = { minimum, maximum }\n"
      "behaviors/odd.lua:8:30: error: history: expected true or false\n");
}

TEST_F(ScriptCheckTest, ChecksTestsAgainstTheDeclarationsOfTheScripts) {
  folder.write("behaviors/a.lua", R"(param { lead = { 1, range = { 0, 2 }, doc = "x" } }
behavior "a" { initial = "here", state "here" {} }
)");
  folder.write("tests/a_test.lua", R"(test("x", function()
  load_behavior "b"
  set_param("a.laed", "1")
  set_world { robot = { posture = "upside down", fallen = true }, confidence = { current = "1" } }
  expect.state("a", "there")
  expect.state("c", "here")
  expect.command("flip", "granted")
  expect.command("flip_pose", "grantd")
  reload { form = "1", to = 2 }
  simulate { scenario = "none", seed = "1" }
  advance("1")
end)
test("y", function()
  load_behavior "a"
  set_param("a.lead", "1")
  set_world { robot = { posture = "lying" }, truth = { x = 1 } }
  expect.state("a", "here")
  expect.command("flip_pose", "granted")
  reload { from = "here", to = "everywhere" }
  expect.state("a", "everywhere")
end)
)");
  EXPECT_EQ(
      findings(),
      "tests/a_test.lua:2:17: error: argument 1 of load_behavior: unknown value 'b' (did you mean 'a'?)\n"
      "tests/a_test.lua:3:13: error: argument 1 of set_param: unknown value 'a.laed' (did you mean 'a.lead'?)\n"
      "tests/a_test.lua:4:35: error: robot.posture: unknown value 'upside down' (expected falling, getting_up, "
      "lifted, lying, upright)\n"
      "tests/a_test.lua:4:50: error: robot has no field 'fallen'\n"
      "tests/a_test.lua:4:92: error: confidence.current: expected a number, found a string\n"
      "tests/a_test.lua:5:21: error: a: unknown state 'there' (did you mean 'here'?)\n"
      "tests/a_test.lua:6:16: error: argument 1 of expect.state: unknown value 'c' (did you mean 'a'?)\n"
      "tests/a_test.lua:7:18: error: argument 1 of expect.command: unknown value 'flip' (did you mean 'flip_pose'?)\n"
      "tests/a_test.lua:8:31: error: argument 2 of expect.command: unknown value 'grantd' (did you mean 'granted'?)\n"
      "tests/a_test.lua:9:12: error: unknown field 'form' (did you mean 'from'?)\n"
      "tests/a_test.lua:9:29: error: to: expected a string, found a number\n"
      "tests/a_test.lua:10:25: error: scenario: unknown value 'none'\n"
      "tests/a_test.lua:10:40: error: seed: expected a number, found a string\n"
      "tests/a_test.lua:11:11: error: argument 1 of advance: expected a number, found a string\n");
}

TEST_F(ScriptCheckTest, AcceptsAStateWithoutExitIfItsInnerStatesChange) {
  folder.write("behaviors/settled.lua", R"(behavior "settled" {
  initial = "young",
  state "young" { { "old", after = 1 } },
  state "old" { initial = "a", state "a" { { "b", after = 1 } }, state "b" { { "a", after = 1 } } },
}
)");
  EXPECT_EQ(findings(), "");
}

TEST_F(ScriptCheckTest, CountsAnExitOfAnInnerStateAsAnExitOfTheOuterState) {
  folder.write("behaviors/nested.lua", R"(behavior "nested" {
  initial = "outer",
  state "outer" { initial = "inner", state "inner" { { "other", after = 1 } } },
  state "other" { { "outer", after = 1 } },
}
)");
  EXPECT_EQ(findings(), "");
}

TEST_F(ScriptCheckTest, ReportsASyntaxErrorWithItsColumn) {
  folder.write("behaviors/broken.lua", "behavior \"broken\" {\n  state \"one\" { then },\n}\n");
  EXPECT_NE(findings().find("behaviors/broken.lua:2:17: error: "), std::string::npos) << findings();
}

TEST_F(ScriptCheckTest, ReportsAScriptThatIsTooLargeToBeLoadedBetweenTwoFrames) {
  folder.write("behaviors/large.lua", "behavior \"large\" {}" + std::string(kLargestScript, ' '));
  EXPECT_EQ(findings(),
            "behaviors/large.lua: error: expected a script of at most 64 KiB, found a larger one (65 KiB)\n");
}

TEST_F(ScriptCheckTest, ReportsABrokenLibraryOnce) {
  folder.write("lib/broken.lua", "local a = {}\nfunction a.x( return 1 end\nreturn a\n");
  folder.write("behaviors/a.lua", "require \"lib.broken\"\nbehavior \"a\" {}\n");
  folder.write("behaviors/b.lua", "require \"lib.broken\"\nbehavior \"b\" {}\n");
  EXPECT_EQ(findings(), "lib/broken.lua:2:15: error: <name> or '...' expected near 'return'\n");
}

TEST_F(ScriptCheckTest, KnowsTheStatesOfOtherBehaviorsAndTheFunctionsOfLibraries) {
  folder.write("lib/steps.lua", "local steps = {}\nfunction steps.count() return 1 end\nreturn steps\n");
  folder.write("behaviors/a.lua", "behavior \"a\" { initial = \"here\", state \"here\" {} }\n");
  folder.write("behaviors/b.lua", R"(local steps = require "lib.steps"
behavior "b" { update = function()
  if behaviors.a.state == "there" then print(steps.counts()) end
end }
)");
  EXPECT_EQ(findings(),
            "behaviors/b.lua:3:27: error: behaviors.a.state: unknown value 'there' (did you mean 'here'?)\n"
            "behaviors/b.lua:3:52: error: lib.steps has no field 'counts' (did you mean 'count'?)\n");
}

TEST_F(ScriptCheckTest, KnowsTheFlagsThatStatesPublish) {
  folder.write("behaviors/a.lua", R"(behavior "a" { initial = "here", state "here" { publishes = "is_here" } })");
  folder.write("behaviors/b.lua",
               "behavior \"b\" { update = function() print(published.is_here, published.is_her) end }\n");
  EXPECT_EQ(findings(), "behaviors/b.lua:1:71: error: no state publishes 'is_her' (did you mean 'is_here'?)\n");
}

/// Each script has one mistake. A script that cannot be loaded must not hide the mistakes of the others.
TEST_F(ScriptCheckTest, ReportsTheMistakesOfAllScriptsAtOnce) {
  folder.write("lib/broken.lua", "local p = param { size = }\nreturn p\n");
  folder.write("behaviors/a.lua", "require \"lib.broken\"\nbehavior \"first\" { publishes = \"is_first\" }\n");
  folder.write("behaviors/b.lua", R"(local p = param { speed = { 1, range = { 0, 2 } } }
behavior "b" { initial = "here", state "here" { { "elsewhere", after = "speed" } } }
)");
  folder.write("behaviors/c.lua", R"(behavior "c" { initial = "here", state "here" {},
  update = function() return behaviors.penalty_mark.state, published.pose_searched, behaviors.first.state == "x",
    published.is_first end
}
)");
  folder.write("scenarios/s.lua", "scenario \"s\" { behaviors = { \"c\" }, initial = \"there\" }\n");
  folder.write("tests/a_test.lua", R"(test("x", function()
  load_behavior "c"
  set_param("b.speed", "1")
  set_param("b.speeed", "1")
  expect.state("c", "gone")
end)
)");
  EXPECT_EQ(
      findings(),
      "behaviors/b.lua:1:19: error: param speed: missing description: doc = \"what it is\"\n"
      "behaviors/b.lua:2:51: error: state 'here': unknown target state 'elsewhere'\n"
      "behaviors/c.lua:2:40: error: unknown behavior 'penalty_mark'\n"
      "behaviors/c.lua:2:70: error: no state publishes 'pose_searched'\n"
      "lib/broken.lua:1:26: error: unexpected symbol near '}'\n"
      "scenarios/s.lua:1:10: error: the machine has an initial state but no states\n"
      "tests/a_test.lua:4:13: error: argument 1 of set_param: unknown value 'b.speeed' (did you mean 'b.speed'?)\n"
      "tests/a_test.lua:5:21: error: c: unknown state 'gone'\n");
}

TEST_F(ScriptCheckTest, RejectsChoicesThatAParameterFileCannotContain) {
  for (const char* choice : {"a\\nb", "\\x1b[31m", "\\xff", "\\127"}) {
    SCOPED_TRACE(choice);
    folder.write("behaviors/a.lua",
                 std::string("local p = param { mode = { \"") + choice + "\", choices = { \"" + choice +
                     "\" }, doc = \"x\" } }\nbehavior \"a\" { update = function() print(p.mode) end }\n");
    EXPECT_NE(findings().find("a choice of param mode: expected printable UTF-8 text without line breaks"),
              std::string::npos)
        << findings();
  }
}

TEST_F(ScriptCheckTest, ChecksLibrariesScenariosAndTests) {
  folder.write("lib/unused.lua", "return { x = robt }\n");
  folder.write("scenarios/s.lua", "scenario \"s\" { update = function() print(truth.z) end }\n");
  folder.write("tests/a_test.lua", "test(\"x\", function() expect.stat(\"a\", \"b\") end)\n");
  EXPECT_EQ(findings(),
            "lib/unused.lua:1:14: error: unknown name 'robt' (did you mean 'robot'?)\n"
            "scenarios/s.lua:1:48: error: truth has no field 'z' (did you mean 'x'?)\n"
            "tests/a_test.lua:1:29: error: expect has no field 'stat' (did you mean 'state'?)\n");
}

TEST_F(ScriptCheckTest, ReportsAnUnknownGlobalOfTheOutermostLevelOnce) {
  folder.write("behaviors/a.lua", "local x = confidense\nbehavior \"a\" {}\n");
  folder.write("behaviors/b.lua", "nothing_like_it = 3\nbehavior \"b\" {}\n");
  EXPECT_EQ(
      findings(),
      "behaviors/a.lua:1:11: error: unknown name 'confidense' (did you mean 'confidence'?)\n"
      "behaviors/b.lua:1:1: error: unknown variable 'nothing_like_it': write 'local nothing_like_it', or keep { } "
      "for values that survive a reload\n");
}

TEST_F(ScriptCheckTest, ReportsTwoBehaviorsWithTheSameName) {
  folder.write("behaviors/a.lua", "behavior \"a\" {}\n");
  folder.write("behaviors/b.lua", "behavior \"a\" {}\n");
  EXPECT_EQ(findings(),
            "behaviors/b.lua:1:10: error: 'a' is also declared in behaviors/a.lua (rename or omit one of them)\n");
}

TEST_F(ScriptCheckTest, CanBeRestrictedToAFile) {
  folder.write("behaviors/a.lua", "behavior \"a\" { update = function() x() end }\n");
  folder.write("behaviors/b.lua", "behavior \"b\" { update = function() y() end }\n");
  const std::filesystem::path only[] = {folder.path() / "behaviors" / "b.lua"};
  const CheckResult result = check_scripts(folder.path(), only);
  ASSERT_EQ(result.findings.size(), 1U);
  EXPECT_EQ(result.findings[0].file, "behaviors/b.lua");
  const std::filesystem::path elsewhere[] = {"/"};
  EXPECT_THROW(check_scripts(folder.path(), elsewhere), std::runtime_error);
}

/// Behaviors, scenarios and tests that use an interface in interfaces/ of the scripts' root.
class ApplicationCheckTest : public ScriptCheckTest {
 protected:
  ApplicationCheckTest() {
    folder.write("interfaces/team.toml", R"([values.drone.height]
type = "number"
description = "x"
[values.drone.mode]
type = "text"
choices = ["hover", "land"]
description = "x"
[values.drone.place]
type = "pose"
description = "x"
[values.others]
type = "list"
most = 3
description = "x"
[values.others.record.name]
type = "text"
description = "x"
[actions.fly]
description = "x"
[actions.fly.arguments.speed]
type = "number"
description = "x"
[actions.fly.arguments.style]
type = "text"
choices = ["slow", "fast"]
default = "slow"
description = "x"
)");
  }
};

TEST_F(ApplicationCheckTest, FindsUnknownValuesActionsAndArguments) {
  folder.write("behaviors/b.lua", R"(local drone = input.drone
behavior "b" { update = function()
  print(input.drone.heigth + 1, input.dron.height, input.age.drone.high, input.valid.othrs)
  if input.drone.mode == "landing" then print(drone.place.rotatio) end
  action.fli { speed = 1 }
  action.fly { sped = 1 }
  action.fly { speed = "fast" }
  action.fly { speed = 1, style = "medium" }
  if action.fly.state == "runing" then print(action.fly.reasn) end
  print(input.drone.mode + 1)
  for _, other in ipairs(input.others) do print(other.name) end
end })");
  EXPECT_EQ(findings(),
            R"(behaviors/b.lua:3:21: error: input.drone has no field 'heigth' (did you mean 'height'?)
behaviors/b.lua:3:39: error: input has no value 'dron' (did you mean 'drone'?)
behaviors/b.lua:3:68: error: input.drone has no field 'high'
behaviors/b.lua:3:86: error: input has no value 'othrs' (did you mean 'others'?)
behaviors/b.lua:4:26: error: input.drone.mode: unknown value 'landing' (expected hover, land)
behaviors/b.lua:4:59: error: the value has no field 'rotatio' (did you mean 'rotation'?)
behaviors/b.lua:5:10: error: the application has no action 'fli' (did you mean 'fly'?)
behaviors/b.lua:6:16: error: action.fly has no field 'sped' (did you mean 'speed'?)
behaviors/b.lua:7:24: error: action.fly.speed: expected a number, found a string
behaviors/b.lua:8:35: error: action.fly.style: unknown value 'medium' (expected fast, slow)
behaviors/b.lua:9:26: error: action.fly.state: unknown value 'runing' (did you mean 'running'?)
behaviors/b.lua:9:57: error: action.fly has no field 'reasn' (did you mean 'reason'?)
behaviors/b.lua:10:9: error: input.drone.mode is a string, and '+' takes a number
)");
}

TEST_F(ApplicationCheckTest, FindsAnActionInACondition) {
  folder.write("behaviors/b.lua", R"(behavior "b" { initial = "a",
  state "a" { { "b", when = function() action.fly { speed = 1 } return input.drone.height > 1 end } },
  state "b" {} })");
  EXPECT_NE(findings().find("behaviors/b.lua:2:"), std::string::npos) << findings();
}

TEST_F(ApplicationCheckTest, ChecksTestsAndScenarios) {
  folder.write("behaviors/b.lua",
               R"(behavior "b" { update = function() action.fly { speed = input.drone.height } end })");
  folder.write("scenarios/s.lua", R"(scenario "s" { behaviors = { "b" }, interface = "team",
  update = function() application.set { drone = { height = 1 } } application.report("fly", "done") end })");
  folder.write("tests/b_test.lua", R"(test("flies", function()
  load_interface "interfaces/team.toml"
  load_behavior "b"
  set_input { drone = { hight = 1.0 } }
  advance(0.1)
  expect.started "fli"
end))");
  EXPECT_EQ(findings(),
            "tests/b_test.lua:4:25: error: input.drone has no field 'hight' (did you mean 'height'?)\n"
            "tests/b_test.lua:6:18: error: argument 1 of expect.started: unknown value 'fli' (did you mean 'fly'?)\n");
}

TEST_F(ApplicationCheckTest, WarnsOfAScenarioWithoutTheInterfaceOfItsBehavior) {
  folder.write("behaviors/b.lua",
               R"(behavior "b" { update = function() action.fly { speed = input.drone.height } end })");
  folder.write("scenarios/s.lua", R"(
scenario "s" { behaviors = { "b" } })");
  folder.write("scenarios/t.lua", R"(scenario "t" { behaviors = { "b" }, interface = "team" })");
  EXPECT_EQ(findings(),
            "scenarios/s.lua:2:10: warning: in behaviors/b.lua, action.fly and 1 more are missing; the interface "
            "'team' has them: interface = \"team\"\n");
}

TEST(MissingValues, AreThoseThatOnlyAnotherInterfaceDeclares) {
  ApplicationInterface team;
  team.name = "team";
  team.values = {{"drone.height", "", {}}, {"drone.mode", "", {}}, {"others", "", {}}};
  team.actions = {{"fly", "", {}}};
  const std::vector<ApplicationInterface> known{team};
  const auto names = [&](const std::string& text, const ApplicationInterface& declared = {}) {
    std::string list;
    for (const MissingValue& one : missing_values(text, declared, known)) list += one.name + " ";
    return list;
  };
  EXPECT_EQ(names("if input.valid.drone.mode and input.drone.height > 1 then action.fly() end"),
            "input.drone.mode input.drone.height action.fly ");
  EXPECT_EQ(names("local d = input.drone print(input.others[1].name)"), "input.drone.height input.others ");
  EXPECT_EQ(names("input.drone.height", team), "");
  EXPECT_EQ(names("input.unknown.x action.unknown() -- input.drone.height"), "");
  EXPECT_EQ(names("my.input.drone.height(\"input.drone.mode\")"), "");
  for (const char* const odd : {"input", "input.", "input.age", "input.age.", "action.", "input..x", ""})
    EXPECT_EQ(names(odd), "") << odd;
  EXPECT_EQ(to_text(missing_values("input.drone.mode", {}, known)),
            "input.drone.mode is missing; the interface 'team' has it");
}

}  // namespace
}  // namespace reorient

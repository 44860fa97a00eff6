// What `reorient check` finds without running a script, and where.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/script/script_texts.h"
#include "tests/temporary_folder.h"
#include "workbench/script_tools/check/name_check.h"
#include "workbench/script_tools/check/script_check.h"

namespace reorient {
namespace {

struct Slip {
  const char* name;
  const char* text;
  const char* message;
  TextPosition position;
};

std::ostream& operator<<(std::ostream& out, const Slip& slip) { return out << slip.name; }

SymbolTable known() {
  SymbolTable names = symbol_table(ScriptRole::behavior);
  names.modules["lib.walk"] = {{"walk_to", "turn"}, {}, false};
  names.states["other"] = {"", "waiting", "going", "going/slowly"};
  names.published = {"pose_is_searched"};
  return names;
}

class NameSlips : public ::testing::TestWithParam<Slip> {};

TEST_P(NameSlips, AreFoundAtTheirPlace) {
  const std::vector<DeclarationError> found = check_names(GetParam().text, known());
  ASSERT_EQ(found.size(), 1U) << (found.empty() ? "nothing found" : found[0].message);
  EXPECT_NE(found[0].message.find(GetParam().message), std::string::npos) << found[0].message;
  EXPECT_EQ(found[0].position.line, GetParam().position.line);
  EXPECT_EQ(found[0].position.column, GetParam().position.column);
}

INSTANTIATE_TEST_SUITE_P(
    Names, NameSlips,
    ::testing::Values(
        Slip{"Global", "local x = confidense", "there is no 'confidense' (did you mean 'confidence'?)", {1, 11}},
        Slip{"Field",
             "return function()\n  return robot.penalised\nend",
             "robot.penalised (did you mean 'penalized'?)",
             {2, 16}},
        Slip{"FieldOfALocalName", "local c = confidence\nreturn c.curent", "confidence.curent", {2, 10}},
        Slip{"Command",
             "return function() command.flip() end",
             "there is no command.flip (did you mean 'flip_pose'?)",
             {1, 27}},
        Slip{"LibraryFunction", "return math.sine(1)", "there is no math.sine", {1, 13}},
        Slip{"Param",
             "local p = param { lead = { 1 } }\nreturn p.leed",
             "no param 'leed' (did you mean 'lead'?)",
             {2, 10}},
        Slip{"ModuleFunction", "local walking = require \"lib.walk\"\nwalking.walk_too()", "lib.walk.walk_too", {2, 9}},
        Slip{"Behavior", "return behaviors.othr.state", "there is no behavior 'othr' (did you mean 'other'?)", {1, 18}},
        Slip{
            "FieldOfABehavior", "return behaviors.other.stat", "behaviors.other.stat (did you mean 'state'?)", {1, 24}},
        Slip{"State",
             "return behaviors.other.state == 'wating'",
             "no state 'wating' (did you mean 'waiting'?)",
             {1, 33}},
        Slip{"StateOnTheLeft", "return \"wating\" ~= behaviors.other.state", "other has no state 'wating'", {1, 8}},
        Slip{"Published",
             "return published.pose_is_serched",
             "no state publishes 'pose_is_serched' (did you mean 'pose_is_searched'?)",
             {1, 18}},
        Slip{"WrittenFlag", "published.pose_is_searched = true", "published.pose_is_searched is read-only", {1, 11}},
        Slip{"NamedValue", "return confidence.status == 'usible'", "'usible'", {1, 29}},
        Slip{"NamedValueOnTheLeft", "return 'up' ~= robot.posture", "'up'", {1, 8}},
        Slip{"NewGlobal", "count = 1", "would be a global variable", {1, 1}},
        Slip{"NewGlobalFunction", "function helper() end", "would be a global variable", {1, 10}},
        Slip{"WrittenField", "robot.penalized = true", "robot.penalized is read-only", {1, 7}},
        Slip{"WrittenParam", "local p = param { a = {} }\np.a = 1", "param.a is read-only", {2, 3}},
        Slip{"ArgumentOfAWrongType",
             "head.look('left', 0)",
             "argument 1 of head.look is a number, not a string",
             {1, 11}},
        Slip{"TooFewArguments", "head.look(1)", "head.look needs 2 arguments, not 1", {1, 10}},
        Slip{"TooManyArguments", "walk.stand(1)", "walk.stand takes no argument, not 1", {1, 11}},
        Slip{"CommandInACondition",
             "return { when = function() return command.flip_pose() end }",
             "a condition only looks",
             {1, 52}},
        Slip{"AfterItsScope", "do local inner = 1 end\nreturn inner", "there is no 'inner'", {2, 8}},
        Slip{"InALoopsHead", "for i = 1, numer do end", "there is no 'numer'", {1, 12}},
        Slip{"InALongTextsNeighbourhood", "local t = [==[ robot.falen\n]==] .. robt", "there is no 'robt'", {2, 9}}),
    [](const auto& each) { return std::string(each.param.name); });

class SoundScripts : public ::testing::TestWithParam<const char*> {};

TEST_P(SoundScripts, GiveNoFindings) {
  for (const DeclarationError& error : check_names(GetParam(), known()))
    ADD_FAILURE() << error.position.line << ":" << error.position.column << ": " << error.message;
}

INSTANTIATE_TEST_SUITE_P(
    Names, SoundScripts,
    ::testing::Values(
        "-- robot.falen in a comment\nlocal s = 'robot.falen'",
        "local function f(a, ...) local b <const> = a; return select('#', ...), b end return f(f)",
        "local t = {} function t.go() end function t:run() return self end t.x, t.y = 1, 2",
        "repeat local done = true until done", "for _, v in ipairs { 1, 2 } do goto next ::next:: print(v) end",
        "local n = 0x1p-4 + 1e-3 + 3 .. '' local m = #'x' - -n // 2", "local robot = { falen = 1 } return robot.falen",
        "local c = confidence; c = { anything = 1 }; return c.anything",
        "return behaviors.other.state == 'go' .. 'ing'",
        "return published.pose_is_searched and robot.posture == 'lying' and confidence.status ~= 'fresh'",
        "return behaviors.other.state == 'going/slowly' and behaviors.other.time_in_state > 1",
        "return { when = function() return time_in_state() > 1 end, enter = function() command.flip_pose() end }",
        "local function pair() return 0.1, 0.2 end return function() head.look(pair()) end",
        "return function() head.look(0.1, 0, nil) head.look(-0.1, 0) end", "return ('x'):rep(3):len()",
        "if robot.penalized then local a = 1 print(a) elseif robot.penalized then local b = 2 print(b) else print(3) "
        "end",
        "while robot.penalized do break end return function(...) return ... end"));

TEST(NameCheck, EndsOnWhateverTextItIsGiven) {
  for (const char* text :
       {"",   "end end", "local", "function", "x.",      "((((",          "for", "if",   "{",
        "}",  "a = = 3", "\"",    "[[",       "--[[",    "return return", "::",  "goto", "local function",
        "f(", "until",   "a,b",   "\\",       "\x80\xFF"}) {
    check_names(text, known());
  }
  check_names(std::string(100'000, '('), known());
  check_names(std::string(100'000, '{'), known());
  std::string nested;
  for (int i = 0; i < 10'000; ++i) nested += "do ";
  check_names(nested, known());
}

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

TEST_F(ScriptCheckTest, TellsAllMistakesOfADeclarationWithLineAndColumn) {
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
  EXPECT_EQ(
      findings(),
      R"(behaviors/wrong.lua:2:10: error: the machine begins in 'watchin', which is not one of its states (did you mean 'watching'?)
behaviors/wrong.lua:5:7: error: state 'watching' leads to 'gonig', which is not a state (did you mean 'going'?)
behaviors/wrong.lua:5:62: error: there is no param 'prof' (did you mean 'proof'?)
behaviors/wrong.lua:6:7: error: state 'watching' leads to 'going' on no condition: give 'when' or 'after'
behaviors/wrong.lua:6:16: error: when is a function, not a number
behaviors/wrong.lua:7:5: error: there is no 'entr' here (did you mean 'enter'?)
behaviors/wrong.lua:10:19: error: after is a number of seconds, 0 or more
behaviors/wrong.lua:11:7: error: state 'going' leads to 'watching' on no condition: give 'when' or 'after'
)");
}

TEST_F(ScriptCheckTest, TellsAllMistakesOfParamsAtTheirNames) {
  folder.write("behaviors/wrong.lua", R"(param {
  outside = { 3, range = { 0, 2 }, doc = "x" },
  silent  = { 1, range = { 0, 2 } },
  open    = { 1, doc = "x" },
}
behavior "wrong" {}
)");
  const std::string found = findings();
  EXPECT_NE(found.find("wrong.lua:2:3: error: "), std::string::npos) << found;
  EXPECT_NE(found.find("wrong.lua:3:3: error: param silent needs a sentence"), std::string::npos) << found;
  EXPECT_NE(found.find("wrong.lua:4:3: error: param open needs range"), std::string::npos) << found;
}

TEST_F(ScriptCheckTest, WarnsOfStatesThatAreNeverReachedAndOfThoseWithoutAWayOut) {
  folder.write("behaviors/odd.lua", R"(behavior "odd" {
  initial = "one",
  state "one" { { "two", after = 1 } },
  state "two" {},
  state "island" { { "one", after = 1 } },
}
)");
  EXPECT_EQ(findings(),
            "behaviors/odd.lua:4:9: warning: state 'two' has no way out\n"
            "behaviors/odd.lua:5:9: warning: state 'island' is never reached\n");
  EXPECT_EQ(check().count(Finding::Severity::error), 0);
}

TEST_F(ScriptCheckTest, RefusesWhatAParameterOfItsKindWouldNotHeed) {
  folder.write("behaviors/odd.lua", R"(param {
  switch = { true, range = { 0, 1 }, doc = "x" },
  choice = { "a", choices = { "a" }, range = { 0, 1 }, doc = "x" },
  number = { 1, range = { 0, 1 }, choices = { "a" }, doc = "x" },
  whole  = { 0.5, range = { 0, 1 }, integer = true, doc = "x" },
  wide   = { 1, range = { 0, 1, 2 }, doc = "x" },
}
behavior "odd" { state "a" { history = "yes" } }
)");
  EXPECT_EQ(findings(),
            "behaviors/odd.lua:2:3: error: param switch is true or false and has no range\n"
            "behaviors/odd.lua:3:3: error: param choice begins with a string, so it is a choice and has no range\n"
            "behaviors/odd.lua:4:3: error: param number is a number and has no choices\n"
            "behaviors/odd.lua:5:3: error: the default of param whole is a whole number\n"
            "behaviors/odd.lua:6:3: error: the range of param wide is { least, greatest }\n");
  folder.write("behaviors/odd.lua", "behavior \"odd\" { state \"a\" { history = \"yes\" } }\n");
  EXPECT_EQ(findings(), "behaviors/odd.lua:1:30: error: history is true or false\n");
}

TEST_F(ScriptCheckTest, WarnsOfAnInitialStateWhenEveryWayInLeadsPastIt) {
  folder.write("behaviors/odd.lua", R"(behavior "odd" {
  initial = "one",
  state "one" { { "two/late", after = 1 } },
  state "two" { initial = "early", { "one", after = 9 }, state "early" { { "late", after = 1 } }, state "late" {} },
}
)");
  EXPECT_EQ(findings(), "behaviors/odd.lua:4:64: warning: state 'two/early' is never reached\n");
}

TEST_F(ScriptCheckTest, WarnsOfATransitionIntoAStateAroundIt) {
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
            "behaviors/odd.lua:5:18: warning: the transition to 'outer' is never taken: 'outer' is active all the "
            "while; name a state in it, or one beside it\n"
            "behaviors/odd.lua:7:11: warning: state 'outer/b' has no way out\n"
            "behaviors/odd.lua:7:19: warning: the transition to 'outer' is never taken: 'outer' is active all the "
            "while; name a state in it, or one beside it\n");
}

TEST_F(ScriptCheckTest, KnowsThatAStateMayLeadToItself) {
  folder.write("behaviors/again.lua", R"(behavior "again" { initial = "a", state "a" { { "a", after = 1 } } })");
  EXPECT_EQ(findings(), "");
}

TEST_F(ScriptCheckTest, LetsAStateWithInnerLifeLastForEver) {
  folder.write("behaviors/settled.lua", R"(behavior "settled" {
  initial = "young",
  state "young" { { "old", after = 1 } },
  state "old" { initial = "a", state "a" { { "b", after = 1 } }, state "b" { { "a", after = 1 } } },
}
)");
  EXPECT_EQ(findings(), "");
}

TEST_F(ScriptCheckTest, TakesAWayOutOfAnInnerStateAsOneOfTheOuter) {
  folder.write("behaviors/nested.lua", R"(behavior "nested" {
  initial = "outer",
  state "outer" { initial = "inner", state "inner" { { "other", after = 1 } } },
  state "other" { { "outer", after = 1 } },
}
)");
  EXPECT_EQ(findings(), "");
}

TEST_F(ScriptCheckTest, PointsASyntaxErrorOutWithItsColumn) {
  folder.write("behaviors/broken.lua", "behavior \"broken\" {\n  state \"one\" { then },\n}\n");
  EXPECT_NE(findings().find("behaviors/broken.lua:2:17: error: "), std::string::npos) << findings();
}

TEST_F(ScriptCheckTest, TellsAScriptThatIsTooLargeToBeLoadedBetweenTwoFrames) {
  folder.write("behaviors/large.lua", "behavior \"large\" {}" + std::string(kLargestScript, ' '));
  EXPECT_EQ(findings(),
            "behaviors/large.lua: error: this is not a plain file below the scripts' root of at most 64 KiB\n");
}

TEST_F(ScriptCheckTest, TellsABrokenLibraryOnce) {
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
            "behaviors/b.lua:3:27: error: a has no state 'there' (did you mean 'here'?)\n"
            "behaviors/b.lua:3:52: error: there is no lib.steps.counts (did you mean 'count'?)\n");
}

TEST_F(ScriptCheckTest, KnowsTheFlagsThatStatesPublish) {
  folder.write("behaviors/a.lua", R"(behavior "a" { initial = "here", state "here" { publishes = "is_here" } })");
  folder.write("behaviors/b.lua",
               "behavior \"b\" { update = function() print(published.is_here, published.is_her) end }\n");
  EXPECT_EQ(findings(), "behaviors/b.lua:1:71: error: no state publishes 'is_her' (did you mean 'is_here'?)\n");
}

TEST_F(ScriptCheckTest, RefusesChoicesThatNoParameterFileCanHold) {
  for (const char* choice : {"a\\nb", "\\x1b[31m", "\\xff", "\\127"}) {
    SCOPED_TRACE(choice);
    folder.write("behaviors/a.lua",
                 std::string("local p = param { mode = { \"") + choice + "\", choices = { \"" + choice +
                     "\" }, doc = \"x\" } }\nbehavior \"a\" { update = function() print(p.mode) end }\n");
    EXPECT_NE(findings().find("a choice of param mode is printable text in UTF-8, without line breaks"),
              std::string::npos)
        << findings();
  }
}

TEST_F(ScriptCheckTest, LooksAtLibrariesScenariosAndTestsToo) {
  folder.write("lib/unused.lua", "return { x = robt }\n");
  folder.write("scenarios/s.lua", "scenario \"s\" { update = function() print(truth.z) end }\n");
  folder.write("tests/a_test.lua", "test(\"x\", function() expect.stat(\"a\", \"b\") end)\n");
  EXPECT_EQ(findings(),
            "lib/unused.lua:1:14: error: there is no 'robt' (did you mean 'robot'?)\n"
            "scenarios/s.lua:1:48: error: there is no truth.z (did you mean 'x'?)\n"
            "tests/a_test.lua:1:29: error: there is no expect.stat (did you mean 'state'?)\n");
}

TEST_F(ScriptCheckTest, TellsTwoBehaviorsOfOneName) {
  folder.write("behaviors/a.lua", "behavior \"same\" {}\n");
  folder.write("behaviors/b.lua", "behavior \"same\" {}\n");
  EXPECT_EQ(findings(), "behaviors/b.lua:1:10: error: 'same' is declared in behaviors/a.lua too\n");
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

TEST(ShippedScripts, PassTheCheckWithoutAWarning) {
  const CheckResult result = check_scripts(std::filesystem::path(REORIENT_SOURCE_DIR) / "scripts", {});
  EXPECT_GE(result.files, 13);
  for (const Finding& finding : result.findings) ADD_FAILURE() << finding.text();
}

}  // namespace
}  // namespace reorient

// SPDX-License-Identifier: MIT
// The runner of scripted tests: its messages, its coverage and its report for CI.
#include <algorithm>
#include <functional>
#include <sstream>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/declared_field.h"
#include "tests/temporary_folder.h"
#include "tests/waiting.h"
#include "workbench/script_tools/testing/junit_report.h"
#include "workbench/script_tools/testing/test_runner.h"

namespace reorient {
namespace {

class ScriptedTests : public ::testing::Test {
 protected:
  ScriptedTests() {
    folder.write("behaviors/lamp.lua", R"(behavior "lamp" {
  initial = "off",
  state "off" { { "on", when = function() return robot.penalized end, because = "dark" } },
  state "on" {
    initial = "dim",
    { "off", when = function() return not robot.penalized end, because = "light" },
    state "dim" { { "bright", after = 1.0 } },
    state "bright" {},
  },
})");
  }

  const TestSummary& run(const std::string& text, Simulate simulate = {}) {
    folder.write("tests/lamp_test.lua", text);
    out.str("");
    trace = {};
    summary = run_script_tests({folder.path(), {}, std::move(simulate), {}, 60.0, {}}, out, trace);
    return summary;
  }
  std::string only_failure() {
    if (summary.cases.size() == 1 && summary.cases[0].failures.size() == 1) return summary.cases[0].failures[0].text;
    ADD_FAILURE() << out.str();
    return {};
  }
  std::string coverage() const {
    std::ostringstream text;
    EXPECT_TRUE(report_coverage(trace, folder.path(), text).empty());
    return text.str();
  }

  TemporaryFolder folder;
  std::ostringstream out;
  CoverageTrace trace;
  TestSummary summary;
};

/// Tests of a behavior with values and actions of an application.
class ScriptedApplicationTests : public ScriptedTests {
 protected:
  ScriptedApplicationTests() {
    folder.write("behaviors/keeper.lua", R"(behavior "keeper" { initial = "waiting",
      state "waiting" { { "catching", when = function() return input.ball.near and input.valid.ball.near end } },
      state "catching" { enter = function() action.catch { hand = "left" } end,
        { "waiting", when = function() return action.catch.state == "done" end, because = "caught" },
        { "sorry", when = function() return action.catch.state == "failed" end, because = "missed" } },
      state "sorry" { enter = function() log.info(action.catch.reason) end } })");
  }
  const TestSummary& run_with_interface(const std::string& test) {
    folder.write("tests/keeper_test.lua",
                 "test(\"one\", function()\n load_interface \"hands\" load_behavior \"keeper\"\n" + test + "\nend)");
    out.str("");
    TestRun run{folder.path(), {}, {}, {}, 60.0, {}};
    run.load_interface = [](const std::string& name) {
      if (name != "hands") throw std::runtime_error("unknown interface '" + name + "'");
      ApplicationInterface declared;
      declared.values.push_back({"ball.near", "", {declared_field("", FieldType::boolean, {{0.0}, {}})}});
      DeclaredField hand;
      hand.name = "hand";
      hand.type = FieldType::text;
      hand.choices = {"left", "right"};
      hand.is_required = true;
      declared.actions.push_back({"catch", "", {hand}, 3.0, true});
      declared.actions.push_back({"throw", "", {declared_field("far", FieldType::number, {{0.0}, {}})}, 1.0, false});
      return declared;
    };
    summary = run_script_tests(run, out, trace);
    return summary;
  }
};

TEST_F(ScriptedApplicationTests, SetValuesAndSeeStartedActions) {
  EXPECT_EQ(run_with_interface(R"(
    advance(0.1)
    expect.not_started "catch"
    set_input { ball = { near = true } }
    advance(0.1)
    expect.state("keeper", "catching")
    expect.started "catch"
    expect.started("catch", { hand = "left" })
    report_action("catch", "running")
    advance(0.1)
    expect.not_started "catch"
    report_action("catch", "failed", "slippery")
    advance(0.1)
    expect.reason("keeper", "missed")
    expect.log "slippery")")
                .passed,
            1)
      << out.str();
}

TEST_F(ScriptedApplicationTests, CompareNumbersOfActionsToAMillionth) {
  folder.write("behaviors/thrower.lua", R"(behavior "thrower" { initial = "a",
    state "a" { enter = function() action.throw { far = math.sin(0.3) ^ 2 + math.cos(0.3) ^ 2 - 0.9 } end } })");
  const std::string begin = "load_behavior 'thrower' advance(0.1) ";
  EXPECT_EQ(run_with_interface(begin + "expect.started('throw', { far = 0.1 })").passed, 1) << out.str();
  EXPECT_EQ(run_with_interface(begin + "expect.started('throw', { far = 0.10001 })").passed, 0) << out.str();
}

TEST_F(ScriptedApplicationTests, FailWithWhatHappenedInstead) {
  run_with_interface("set_input { ball = { near = true } } advance(0.1) expect.started('catch', { hand = 'right' })");
  EXPECT_EQ(only_failure(), "expected start of catch { hand = \"right\" }\n  actual catch { hand = \"left\" }");
  run_with_interface("advance(0.1) expect.started 'catch'");
  EXPECT_EQ(only_failure(), "expected start of catch\n  actual no start");
  run_with_interface("set_input { ball = { near = true } } advance(0.1) expect.not_started 'catch'");
  EXPECT_EQ(only_failure(), "expected no start of catch\n  actual catch { hand = \"left\" }");
}

TEST_F(ScriptedApplicationTests, RefuseWrongNamesAndTypes) {
  const struct {
    const char* line;
    const char* message;
  } cases[] = {
      {"set_input { ball = { neer = true } }", "input has no value 'ball.neer' (did you mean 'ball.near'?)"},
      {"set_input { ball = { near = 3 } }", "ball.near: expected true or false, found a number"},
      {"set_input { bal = 1 }", "input has no value 'bal'"},
      {"set_input(3)", "input: expected a table of values, as in { ball = { x = 1.0 } }, found a number"},
      {"expect.started 'cach'", "unknown action 'cach' (did you mean 'catch'?)"},
      {"expect.started('catch', { hand = 'up' })", "catch: hand: expected left or right, found 'up'"},
      {"report_action('catch', 'done')", "expected a report about an action that was requested"},
      {"load_interface 'hands'", "load_interface: expected a call before load_behavior and load_scenario"},
  };
  for (const auto& [line, message] : cases) {
    run_with_interface(line);
    EXPECT_NE(only_failure().find(message), std::string::npos) << line << ": " << out.str();
  }
}

TEST_F(ScriptedTests, WithoutInterfacesSayThatTheyAreNotSupported) {
  run(R"(test("one", function() load_interface "hands" end))");
  EXPECT_NE(only_failure().find("load_interface: interfaces are not supported here"), std::string::npos);
}

TEST_F(ScriptedTests, ReceiveAndSendMessagesOfTheTeam) {
  folder.write("behaviors/parrot.lua", R"(behavior "parrot" {
    update = function() for i = 1, team.heard() do team.send(team.sender(i) .. ": " .. team.text(i)) end end
  })");
  run(R"(test("repeats what it hears, once", function()
  load_behavior "parrot"
  hear(2, "hello")
  hear(5, "there")
  advance(0.1)
  expect.message("2: hello")
  expect.message("5: there")
  advance(0.1)
  expect.message("hello")
end))");
  EXPECT_EQ(only_failure(), "expected a message with \"hello\"\n  actual no message");
}

TEST_F(ScriptedTests, RejectImpossibleMessages) {
  for (const char* arguments : {"0.5, 'x'", "1e9, 'x'", "1, string.rep('x', 241)"}) {
    run(std::string("test(\"hears\", function() hear(") + arguments + ") end)");
    EXPECT_NE(only_failure(), "") << arguments;
  }
  run("test(\"hears\", function() for i = 1, 33 do hear(1, 'x') end end)");
  EXPECT_NE(only_failure().find("at most 32 messages"), std::string::npos);
}

TEST_F(ScriptedTests, SeeThatAKnownAsymmetricRoomCanTellThePosesApart) {
  run(R"(test("t", function()
  for status, can_tell in pairs { usable = true, off = false, resting = false, unlearned = false, symmetric = false,
                                  lost = true, fresh = true } do
    set_world { confidence = { status = status } }
    advance(0.1)
    expect.equal(world_value("confidence.can_tell"), can_tell)
  end
end))");
  EXPECT_EQ(summary.failed, 0) << out.str();
}

TEST_F(ScriptedTests, ReportEachFailureWithItsLineAndBothValues) {
  run(R"(test("is wrong twice", function()
  load_behavior "lamp"
  advance(0.1)
  expect.state("lamp", "on")
  expect.no_command()
  expect.equal(1 + 1, 3)
end))");
  EXPECT_EQ(summary.failed, 1);
  ASSERT_EQ(summary.cases[0].failures.size(), 2U);
  EXPECT_NE(out.str().find("FAILED  tests/lamp_test.lua: is wrong twice\n"
                           "    tests/lamp_test.lua:4:\n"
                           "      expected lamp in state \"on\"\n"
                           "        actual in state \"off\"\n"
                           "    tests/lamp_test.lua:6:\n"
                           "      expected 3\n"
                           "        actual 2\n"),
            std::string::npos)
      << out.str();
}

TEST_F(ScriptedTests, PrintBelowTheirResult) {
  run(R"(test("prints", function() print("pose", 1.5, nil, { }) print("two\nlines") print() end))");
  EXPECT_EQ(summary.failed, 0) << out.str();
  EXPECT_NE(out.str().find("ok      tests/lamp_test.lua: prints\n"
                           "    printed: pose 1.5 nil table\n"
                           "    printed: two lines\n"
                           "    printed: \n"),
            std::string::npos)
      << out.str();
  run("test(\"prints\", function() for i = 1, 1e6 do print(i) end end)");
  EXPECT_EQ(only_failure().substr(0, only_failure().find('\n')), "print: expected at most 1000 lines in a test");
  run("print(1) test(\"prints\", function() end)");
  EXPECT_NE(only_failure().find("print: expected a call in a test"), std::string::npos) << only_failure();
}

TEST_F(ScriptedTests, SayWhatToWriteInsteadOfAWordOfBehaviors) {
  const std::pair<const char*, const char*> words[] = {
      {"published.is_lost", "published: a word of behaviors and scenarios, not of tests; expect.state("},
      {"behaviors.lamp.state", "behaviors: a word of behaviors and scenarios, not of tests; expect.state("},
      {"time_in_state()", "advance(SECONDS) lets time pass"},
      {"command.flip_pose()", "expect.command(\"NAME\") checks a command of a behavior"},
      {"log.info(\"x\")", "print(\"TEXT\") prints a line"},
      {"param { }", "set_param(\"NAME\", \"VALUE\")"},
      {"truth.x", "set_world { truth = { x = 1 } } sets the true pose"},
      {"pose.x", "pose: a table of the world, which tests do not have; world_value(\"pose.FIELD\") reads a value"},
      {"confidence.opposite", "world_value(\"confidence.FIELD\")"},
  };
  for (const auto& [word, why] : words) {
    run(std::string("test(\"t\", function() local x = ") + word + " end)");
    EXPECT_NE(only_failure().find(why), std::string::npos) << word << ": " << only_failure();
  }
  run(R"(test("t", function() expect.equal(some_global, nil) end))");
  EXPECT_EQ(summary.failed, 0) << "a missing global of another name stays nil";
}

TEST_F(ScriptedTests, ShowWhereTwoTablesDiffer) {
  run(R"(test("t", function()
  expect.equal({ a = 1, b = { "x", "y" }, extra = true }, { a = 1, b = { "x", "z" }, missing = 2 })
end))");
  const std::string text = only_failure();
  EXPECT_NE(text.find("at .b[2]: expected \"z\", actual \"y\""), std::string::npos) << text;
  EXPECT_NE(text.find("at .missing: expected 2, actual nil"), std::string::npos) << text;
  EXPECT_NE(text.find("at .extra: expected nothing, actual true"), std::string::npos) << text;
}

TEST_F(ScriptedTests, TreatTablesWithTheSameFieldsAsEqual) {
  run(R"(test("t", function() expect.equal({ 1, { x = 2.0 } }, { 1.0, { x = 2 } }) end))");
  EXPECT_EQ(summary.failed, 0) << out.str();
}

TEST_F(ScriptedTests, EndOnTablesThatContainThemselves) {
  run(R"(test("t", function() local a, b = {}, {} a.a = a b.a = b expect.equal(a, b) end))");
  EXPECT_EQ(summary.failed, 1);
}

TEST_F(ScriptedTests, EndOnTablesThatStandInEachOtherAgainAndAgain) {
  run(R"(local function nested(leaf)
  local t = { leaf }
  for _ = 1, 15 do
    local level = {}
    for i = 1, 20 do level[i] = t end
    t = level
  end
  return t
end
test("t", function() expect.equal(nested(1), nested(1)) end))");
  EXPECT_EQ(summary.failed, 1);
  EXPECT_NE(out.str().find("instructions"), std::string::npos) << out.str();
}

TEST_F(ScriptedTests, CountTheStatesAndTransitionsThatTheyCovered) {
  run(R"(test("t", function() load_behavior "lamp" set_world { robot = { penalized = true } } advance(0.5) end))");
  EXPECT_EQ(coverage(),
            "lamp: 3 of 4 states, 1 of 3 transitions\n"
            "  behaviors/lamp.lua:8:11: never entered: on/bright\n"
            "  behaviors/lamp.lua:6:7: never taken: on > off (light)\n"
            "  behaviors/lamp.lua:7:21: never taken: on/dim > on/bright (after 1.0 s)\n"
            "total: 3 of 4 states (75 %), 1 of 3 transitions (33 %) of the 1 machine that tests loaded\n");
}

TEST_F(ScriptedTests, ReportEachMachineThatNoTestLoadsInOneLine) {
  folder.write("scenarios/night.lua", R"(scenario "night" { state "dark" {} })");
  run(R"(test("t", function() end))");
  EXPECT_EQ(coverage(),
            "lamp: no test loaded it\n"
            "night: no test loaded it\n"
            "total: 0 of 5 states (0 %), 0 of 3 transitions (0 %): no test loaded a machine\n");
  run(R"(test("t", function() load_behavior "lamp" advance(0.1) end))");
  EXPECT_TRUE(
      coverage().ends_with("night: no test loaded it\n"
                           "total: 1 of 4 states (25 %), 0 of 3 transitions (0 %) of the 1 machine that tests "
                           "loaded; 1 of 5 states (20 %), 0 of 3 transitions (0 %) of all 2 machines\n"))
      << coverage();
}

/// A library whose functions create a transition, a state and a whole machine.
void write_makers(const TemporaryFolder& folder) {
  folder.write("lib/makers.lua", R"(local makers = {}
function makers.when_penalized(target)
  return { target, when = function() return robot.penalized end, because = "penalized" }
end
function makers.pause(target)
  return state "pause" { { target, after = 1 } }
end
function makers.blinker(name)
  behavior(name) { initial = "on", state "on" { { "off", after = 1 } }, state "off" { { "on", after = 1 } } }
end
return makers)");
}

TEST_F(ScriptedTests, ReportStatesOfALibraryAsAFractionOnly) {
  write_makers(folder);
  folder.write("behaviors/guest.lua", R"(local makers = require "lib.makers"
behavior "guest" {
  initial = "here",
  common = { makers.when_penalized("pause") },
  state "here" { { "away", after = 5 }, makers.when_penalized("away") },
  state "away" { { "here", after = 5 } },
  makers.pause("here"),
})");
  folder.write("behaviors/sign.lua", R"(require("lib.makers").blinker("sign"))");
  run(R"(test("t", function()
  load_behavior "guest"
  load_behavior "sign"
  advance(0.1)
  set_world { robot = { penalized = true } }
  advance(0.1)
end))");
  EXPECT_EQ(summary.failed, 0) << out.str();
  EXPECT_EQ(coverage(),
            "guest: 1 of 2 states, 0 of 2 transitions\n"
            "  behaviors/guest.lua:6:9: never entered: away\n"
            "  behaviors/guest.lua:5:20: never taken: here > away (after 5 s)\n"
            "  behaviors/guest.lua:6:20: never taken: away > here (after 5 s)\n"
            "  from lib/makers.lua: 1 of 1 states, 1 of 3 transitions\n"
            "sign: 0 of 0 states, 0 of 0 transitions\n"
            "  from lib/makers.lua: 1 of 2 states, 0 of 2 transitions\n"
            "lamp: no test loaded it\n"
            "total: 1 of 2 states (50 %), 0 of 2 transitions (0 %) of the 2 machines that tests loaded; "
            "from libraries: 2 of 3 states (66 %), 1 of 5 transitions (20 %); "
            "1 of 6 states (16 %), 0 of 5 transitions (0 %) of all 3 machines\n");
}

TEST_F(ScriptedTests, CountATransitionThatOnlyCallsALibraryForTheBehavior) {
  folder.write("lib/asked.lua", "return { never = function() return false end }");
  folder.write("behaviors/asking.lua", R"(local asked = require "lib.asked"
behavior "asking" { state "a" { { "b", when = asked.never }, state "b" { { "a", after = 1 } } } })");
  run(R"(test("t", function() load_behavior "asking" advance(0.1) end))");
  EXPECT_NE(coverage().find("  behaviors/asking.lua:2:35: never taken: a > a/b (its condition held)\n"),
            std::string::npos)
      << coverage();
  EXPECT_EQ(coverage().find("lib/asked.lua"), std::string::npos) << coverage();
}

TEST_F(ScriptedTests, DistinguishMachinesWithTheSameNameInDifferentFiles) {
  folder.write("behaviors/old/lamp.lua", R"(behavior "lamp" { state "off" {} })");
  run(R"(test("t", function() load_behavior "lamp" advance(0.1) end))");
  EXPECT_NE(coverage().find("lamp: no test loaded it\n"), std::string::npos) << coverage();
}

TEST_F(ScriptedTests, OmitAScriptThatCannotBeLoadedFromTheCoverageAndReportWhy) {
  folder.write("behaviors/broken.lua", "behavior \"broken\" {");
  run(R"(test("t", function() load_behavior "lamp" advance(0.1) end))");
  std::ostringstream text;
  const std::vector<std::string> failures = report_coverage(trace, folder.path(), text);
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_TRUE(failures[0].starts_with("behaviors/broken.lua is not in the coverage: behaviors/broken.lua:1"))
      << failures[0];
  EXPECT_NE(text.str().find("lamp: 1 of 4 states"), std::string::npos) << text.str();
  EXPECT_NE(text.str().find("\ntotal: "), std::string::npos) << text.str();
}

TEST_F(ScriptedTests, CountTransitionsAfterAnEdit) {
  run(R"(test("t", function()
  load_behavior "lamp"
  advance(0.1)
  reload { from = "initial = \"off\"", to = "priority = 3, initial = \"off\"" }
  set_world { robot = { penalized = true } }
  advance(1.5)
  set_world { robot = { penalized = false } }
  advance(0.1)
end))");
  EXPECT_EQ(coverage(),
            "lamp: 4 of 4 states, 3 of 3 transitions\n"
            "total: 4 of 4 states (100 %), 3 of 3 transitions (100 %) of the 1 machine that tests loaded\n")
      << out.str();
}

TEST_F(ScriptedTests, WriteAReportForCi) {
  run(R"(test("good", function() end) test("bad <&\">", function() expect.equal(1, 2) end))");
  for (TestCase& test : summary.cases) test.seconds = 0.25;
  EXPECT_EQ(junit_report(summary, {"nao<1>", "2026-11-29T15:30:00"}), R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuite name="reorient test" timestamp="2026-11-29T15:30:00" hostname="nao&lt;1&gt;" tests="2" failures="1" errors="0" skipped="0" time="0.500">
  <properties/>
  <testcase classname="tests/lamp_test.lua" name="good" time="0.250">
  </testcase>
  <testcase classname="tests/lamp_test.lua" name="bad &lt;&amp;&quot;&gt;" time="0.250">
    <failure message="tests/lamp_test.lua:1" type="expectation">expected 2
  actual 1</failure>
  </testcase>
  <system-out/>
  <system-err/>
</testsuite>
)");
}

TEST_F(ScriptedTests, ReportAllFailuresOfATestInOneElement) {
  run("test('t', function()\n  expect.equal(1, 2)\n  expect.equal(3, 4)\nend)");
  const std::string report = junit_report(summary, {});
  EXPECT_NE(report.find("<failure message=\"tests/lamp_test.lua:2\" type=\"expectation\">expected 2\n  actual 1\n"
                        "tests/lamp_test.lua:3:\nexpected 4\n  actual 3</failure>"),
            std::string::npos)
      << report;
  EXPECT_EQ(report.find("<failure"), report.rfind("<failure"));
}

TEST_F(ScriptedTests, AreReportedAsErrorsIfTheirFileCannotRun) {
  run("test('t', function() end) error('no')");
  const std::string report = junit_report(summary, {});
  EXPECT_NE(report.find("tests=\"1\" failures=\"0\" errors=\"1\""), std::string::npos) << report;
  EXPECT_NE(report.find("<error message=\"tests/lamp_test.lua:1\" type=\"not run\">"), std::string::npos) << report;
}

TEST_F(ScriptedTests, TakeWallClockTime) {
  run("test('t', function() for i = 1, 100000 do end end) test('u', function() end)");
  EXPECT_GT(summary.cases[0].seconds, 0.0);
  EXPECT_GT(summary.cases[1].seconds, 0.0);
}

TEST_F(ScriptedTests, AreReportedAsSkippedWithoutASimulator) {
  run(R"(test("t", function() simulate { scenario = "s" } expect.equal(1, 2) end))");
  EXPECT_EQ(summary.skipped, 1);
  EXPECT_EQ(summary.failed, 0);
  EXPECT_NE(out.str().find("skipped tests/lamp_test.lua: t\n"), std::string::npos) << out.str();
  EXPECT_NE(junit_report(summary, {}).find("<skipped/>"), std::string::npos);
}

TEST_F(ScriptedTests, ApplyExpectationsToAWholeSimulation) {
  SimulationRequest requested;
  run(R"(test("t", function()
  local is_correct = simulate { scenario = "s", with = { "a", "b" }, seed = 7, width = 320, seconds = 12.5, room_awareness = false,
    params = { ["lamp.on"] = true, ["lamp.level"] = 0.5 } }
  expect.equal(is_correct, true)
  expect.verdict(true, "fine")
  expect.state("lamp", "on/dim")
  expect.command("flip_pose", "granted")
  expect.reason("lamp", "dark")
  expect.log("hello")
end))",
      [&](const SimulationRequest& request, CoverageTrace&, const std::function<bool()>&) {
        requested = request;
        SimulationOutcome outcome;
        outcome.is_correct = true;
        outcome.seen.verdict = ScenarioVerdict{true, "all fine", 3.0};
        outcome.seen.machines.push_back({"lamp", "on/dim"});
        outcome.seen.commands.push_back({"flip_pose", "granted"});
        outcome.seen.transitions.push_back({"lamp", "dark"});
        outcome.seen.logs.emplace_back("hello there");
        return outcome;
      });
  EXPECT_EQ(summary.failed, 0) << out.str();
  EXPECT_EQ(requested.scenario, "s");
  EXPECT_EQ(requested.with, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(requested.seed, 7U);
  EXPECT_EQ(requested.width, 320);
  EXPECT_EQ(requested.seconds, 12.5);
  EXPECT_FALSE(requested.room_awareness);
  std::sort(requested.parameters.begin(), requested.parameters.end());
  EXPECT_EQ(requested.parameters,
            (std::vector<std::pair<std::string, std::string>>{{"lamp.level", "0.5"}, {"lamp.on", "true"}}));
}

TEST_F(ScriptedTests, FailIfAScriptOfTheSimulationFails) {
  run(R"(test("t", function() simulate { scenario = "s" } end))",
      [](const SimulationRequest&, CoverageTrace&, const std::function<bool()>&) {
        SimulationOutcome outcome;
        outcome.seen.faults.push_back({"behaviors/lamp.lua", 3, "it broke", {}});
        return outcome;
      });
  EXPECT_EQ(summary.failed, 1);
  EXPECT_NE(out.str().find("behaviors/lamp.lua:3"), std::string::npos) << out.str();
}

struct BadRequest {
  const char* table;
  const char* message;
};

TEST_F(ScriptedTests, RejectInvalidSimulations) {
  for (const BadRequest& bad :
       {BadRequest{"{}", "missing scenario"}, BadRequest{"{ scenari = 'x' }", "did you mean 'scenario'"},
        BadRequest{"{ scenario = 'x', seed = -1 }", "seed"}, BadRequest{"{ scenario = 'x', seed = 1.5 }", "seed"},
        BadRequest{"{ scenario = 'x', width = 100 }", "width"}, BadRequest{"{ scenario = 'x', with = 'a' }", "with"},
        BadRequest{"{ scenario = 'x', with = { 1 } }", "with"},
        BadRequest{"{ scenario = 'x', seconds = 0/0 }", "seconds"},
        BadRequest{"{ scenario = 'x', params = { 1 } }", "params"}, BadRequest{"'x'", "table"}}) {
    run(std::string("test(\"t\", function() simulate(") + bad.table + ") end)",
        [](const SimulationRequest&, CoverageTrace&, const std::function<bool()>&) { return SimulationOutcome{}; });
    EXPECT_EQ(summary.failed, 1) << bad.table;
    EXPECT_NE(out.str().find(bad.message), std::string::npos) << bad.table << "\n" << out.str();
  }
}

// ---- limits, because tests are untrusted scripts, too

TEST_F(ScriptedTests, CannotDeclareTestsWhileATestRuns) {
  run(R"(test("outer", function() test("inner", function() end) end)
test("caught", function() for i = 1, 100 do pcall(test, "inner " .. i, function() end) end end))");
  ASSERT_EQ(summary.cases.size(), 2U) << out.str();
  ASSERT_EQ(summary.cases[0].failures.size(), 1U);
  EXPECT_NE(summary.cases[0].failures[0].text.find("declare tests at the top level of the file"), std::string::npos);
  EXPECT_TRUE(summary.cases[1].failures.empty()) << out.str();
}

TEST_F(ScriptedTests, CannotDeclareMachinesOrParameters) {
  for (const std::string word : {"behavior", "scenario", "param", "keep"}) {
    run("test(\"t\", function() " + word + " { } end)");
    EXPECT_NE(only_failure().find(word + ": a word of behaviors and scenarios, not of tests"), std::string::npos)
        << only_failure();
  }
}

TEST_F(ScriptedTests, AreIsolatedFromEachOther) {
  run(R"(local count = 0
local function is_untouched()
  count = count + 1
  local text = tostring(string.leak) .. tostring(expect.leak) .. tostring(leak) .. count
  return text == "nilnilnil1"
end
for i = 1, 3 do
  test("t" .. i, function()
    expect.equal(is_untouched(), true)
    pcall(function() string.leak = 1 end)
    pcall(function() expect.leak = 1 end)
    pcall(function() leak = advance end)
    pcall(function() math.floor = nil end)
    expect.equal(math.floor(1.5), 1)
  end)
end)");
  EXPECT_EQ(summary.passed + summary.failed, 3);
  EXPECT_EQ(summary.cases[1].failures.size(), summary.cases[0].failures.size()) << out.str();
  for (const TestCase& test : summary.cases) {
    for (const TestFailure& failure : test.failures) EXPECT_EQ(failure.text.find("actual false"), std::string::npos);
  }
}

TEST_F(ScriptedTests, EndAtTheLimitOfTheRobotsTime) {
  run(R"(test("t", function()
  while true do
    pcall(advance, 3600)
  end
end)
test("the next", function() advance(1) end))");
  ASSERT_EQ(summary.cases.size(), 2U);
  ASSERT_EQ(summary.cases[0].failures.size(), 1U) << out.str();
  EXPECT_NE(summary.cases[0].failures[0].text.find("more than 36000 s of the robot's time"), std::string::npos)
      << out.str();
  EXPECT_EQ(summary.passed, 1);
}

/// s. On a busy machine, a test may reach its limit in any of its calls. It must not reach the limit of its file, which
/// is ten times longer.
constexpr double kShortLimit = 1.0;

TEST_F(ScriptedTests, EndAtTheTimeout) {
  // Called before each frame, so that the robot's time exceeds the limit on a fast machine, too.
  const auto slow_stop = [] {
    let_time_pass(0.001);
    return false;
  };
  TestRun hasty{folder.path(), {}, {}, {}, kShortLimit, slow_stop};
  folder.write("tests/lamp_test.lua", R"(test("t", function()

  load_behavior "lamp" while true do advance(100) end
end))");
  summary = run_script_tests(hasty, out, trace);
  ASSERT_EQ(summary.cases.size(), 1U);
  ASSERT_EQ(summary.cases[0].failures.size(), 1U) << out.str();
  EXPECT_EQ(summary.cases[0].failures[0].line, 3);
  EXPECT_NE(summary.cases[0].failures[0].text.find("took more than 1 s; --timeout"), std::string::npos) << out.str();
}

TEST_F(ScriptedTests, PayForTheWorkOfEachFunction) {
  TestRun hasty{folder.path(), {}, {}, {}, 0.05, {}};
  for (const char* work : {"reload { from = 'bright', to = 'bright' }", "pcall(load_behavior, 'lamp')",
                           "set_world { robot = { penalized = true } }", "set_param('arbiter.rest', '1')",
                           "expect.equal(big, big)", "pcall(load_scenario, 'none')"}) {
    SCOPED_TRACE(work);
    folder.write(
        "tests/lamp_test.lua",
        std::string("local big = {} for i = 1, 20000 do big[i] = { i } end\ntest('t', function() load_behavior "
                    "'lamp' while true do pcall(function() ") +
            work + " end) end end)");
    out.str("");
    summary = run_script_tests(hasty, out, trace);
    EXPECT_EQ(summary.failed, 1);
  }
}

TEST_F(ScriptedTests, EndAfterTooManyFailures) {
  run("test('t', function() while true do expect.equal(1, 2) end end)");
  ASSERT_EQ(summary.cases.size(), 1U);
  EXPECT_EQ(summary.cases[0].failures.size(), 101U);
  EXPECT_NE(out.str().find("ended after 100 failures"), std::string::npos);
}

TEST_F(ScriptedTests, AreLimitedInNumberInAFile) {
  run("for i = 1, 1e6 do test('t', function() end) end");
  EXPECT_EQ(summary.failed, 1);
  EXPECT_NE(out.str().find("expected at most 2000 tests in a file"), std::string::npos) << out.str();
}

TEST_F(ScriptedTests, HaveNamesThatCanBeRead) {
  run("test(('x'):rep(1000000), function() end)");
  EXPECT_EQ(summary.failed, 1);
  EXPECT_NE(out.str().find("expected a name of at most 200 characters"), std::string::npos)
      << out.str().substr(0, 1000);
}

TEST_F(ScriptedTests, TellFailuresThatCanBeRead) {
  run(R"(local long = ("x"):rep(1000000)
test("error", function() error(long) end)
test("values", function() expect.equal(long, long .. "y") end)
test("parameter", function() set_param(long, "1") end))");
  EXPECT_EQ(summary.failed, 3);
  for (const TestCase& test : summary.cases) EXPECT_LT(test.failures.at(0).text.size(), 20'000U) << test.name;
}

TEST_F(ScriptedTests, EditNoScriptBeyondWhatOneMayBe) {
  run(R"(test("t", function()
  load_behavior "lamp"
  reload { from = "e", to = ("x"):rep(1000000) }
end))");
  EXPECT_NE(only_failure().find("longer than 64 KiB"), std::string::npos);
}

TEST_F(ScriptedTests, PayForEachTextOfASimulation) {
  run(R"(local long, with, params = ("x"):rep(16000), {}, {}
for i = 1, 4000 do with[i] = long params["p" .. i] = long end
test("with", function() simulate { scenario = "s", with = with } end)
test("params", function() simulate { scenario = "s", params = params } end))",
      [](const SimulationRequest&, CoverageTrace&, const std::function<bool()>&) { return SimulationOutcome{}; });
  EXPECT_EQ(summary.failed, 2);
  EXPECT_NE(out.str().find("instructions"), std::string::npos) << out.str();
}

TEST_F(ScriptedTests, PayForEachParameterThatTheySet) {
  run("test('t', function() for i = 1, 1e6 do set_param('x' .. i, '1') end end)");
  EXPECT_EQ(summary.failed, 1);
  EXPECT_LT(summary.cases.at(0).failures.size(), 200U);
  EXPECT_NE(out.str().find("instructions"), std::string::npos) << out.str().substr(0, 1000);
}

TEST_F(ScriptedTests, EndAllIfTheirFileTakesTooLong) {
  TestRun hasty{folder.path(), {}, {}, {}, 0.05, {}};
  folder.write("tests/lamp_test.lua",
               "for i = 1, 30 do test('t' .. i, function() while true do advance(100) end end) end");
  summary = run_script_tests(hasty, out, trace);
  EXPECT_EQ(summary.failed, 30);
  EXPECT_NE(out.str().find("not run: the file's tests took more than 0.5 s"), std::string::npos) << out.str();
}

TEST_F(ScriptedTests, EndInTheMiddleOfASimulation) {
  bool was_asked_to_stop = false;
  TestRun hasty{folder.path(), {}, {}, {}, kShortLimit, {}};
  hasty.simulate = [&](const SimulationRequest&, CoverageTrace&, const std::function<bool()>& stop) {
    while (!stop()) {
    }
    was_asked_to_stop = true;
    return SimulationOutcome{};
  };
  folder.write("tests/lamp_test.lua", "test('t', function() while true do simulate { scenario = 's' } end end)");
  summary = run_script_tests(hasty, out, trace);
  EXPECT_TRUE(was_asked_to_stop);
  EXPECT_EQ(summary.failed, 1);
  EXPECT_NE(out.str().find("--timeout"), std::string::npos) << out.str();
}

TEST_F(ScriptedTests, LimitASimulationToTheRemainingTimeOfTheRobot) {
  std::vector<double> requested;
  run("test('t', function() for i = 1, 3 do simulate { scenario = 's', seconds = 20000 } end end)",
      [&](const SimulationRequest& request, CoverageTrace&, const std::function<bool()>&) {
        requested.push_back(request.seconds);
        SimulationOutcome outcome;
        outcome.seconds = request.seconds;
        return outcome;
      });
  EXPECT_EQ(requested, (std::vector<double>{20000.0, 16000.0}));
  EXPECT_EQ(summary.failed, 1);
}

TEST_F(ScriptedTests, StopOnAnInterrupt) {
  int questions = 0;
  TestRun interrupted{folder.path(), {}, {}, {}, 60.0, [&] { return ++questions > 100; }};
  folder.write("tests/lamp_test.lua",
               "test('a', function() advance(1) end)\ntest('b', function() while true do advance(100) end end)\n"
               "test('c', function() end)");
  summary = run_script_tests(interrupted, out, trace);
  EXPECT_TRUE(summary.interrupted);
  EXPECT_EQ(summary.cases.size(), 2U) << out.str();
  EXPECT_NE(out.str().find("interrupted before the remaining tests"), std::string::npos) << out.str();
}

struct Mistake {
  const char* name;
  const char* body;
  const char* message;
};
std::ostream& operator<<(std::ostream& out, const Mistake& mistake) { return out << mistake.name; }

class MistakesOfTests : public ScriptedTests, public ::testing::WithParamInterface<Mistake> {};

TEST_P(MistakesOfTests, AreReported) {
  folder.write("behaviors/dimmer.lua", R"(local p = param { level = { 0.5, range = { 0, 1 }, doc = "how bright" } }
behavior "dimmer" { initial = "on", state "on" {} })");
  run(std::string("test('t', function()\n") + GetParam().body + "\nend)");
  EXPECT_EQ(summary.failed, 1) << out.str();
  EXPECT_NE(out.str().find(GetParam().message), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("tests/lamp_test.lua:2"), std::string::npos) << "where\n" << out.str();
}

INSTANTIATE_TEST_SUITE_P(
    Language, MistakesOfTests,
    ::testing::Values(
        Mistake{"UnknownParameter", "set_param('dimmer.levle', '0.3')  load_behavior 'dimmer'",
                "unknown parameter 'dimmer.levle' of the scripts that this test loads (did you mean 'dimmer.level'?)"},
        Mistake{"ParameterOfAScriptThatIsNotLoaded", "set_param('dimmer.level', '0.3')",
                "unknown parameter 'dimmer.level'"},
        Mistake{"ParameterOutOfRange", "load_behavior 'dimmer'  set_param('dimmer.level', '3')", "dimmer.level"},
        Mistake{"WorldField", "set_world { robot = { penalised = true } }", "did you mean 'robot.penalized'?"},
        Mistake{"WorldTable", "set_world { robto = { penalized = true } }", "unknown world field 'robto.penalized'"},
        Mistake{"WorldType", "set_world { robot = { penalized = 'yes' } }", "robot.penalized"},
        Mistake{"WorldName", "set_world { robot = { posture = 'flying' } }", "robot.posture"},
        Mistake{"WorldRange", "set_world { confidence = { current = 7 } }", "confidence.current"},
        Mistake{"WorldPose", "set_world { pose = { x = 1e308 } }",
                "pose.x: expected a finite number, from -100 to 100"},
        Mistake{"WorldNumber", "set_world { confidence = { current = 0/0 } }", "confidence.current"},
        Mistake{"Clock", "set_world { clock = { time = 9 } }",
                "clock.time cannot be set: advance(SECONDS) lets time pass"},
        Mistake{"WorldComputed", "set_world { confidence = { can_tell = true } }",
                "confidence.can_tell cannot be set: it is computed from confidence.status"},
        Mistake{"BehaviorTwice", "load_behavior 'lamp'  load_behavior 'lamp'",
                "load_behavior: 'lamp' is already loaded"},
        Mistake{"NoBehavior", "load_behavior 'lapm'", "lapm"},
        Mistake{"TooLong", "advance(1e9)", "advance: expected seconds from 0 to 3600"},
        Mistake{"Backwards", "advance(-1)", "advance: expected seconds"},
        Mistake{"NotANumberOfSeconds", "advance(0/0)", "finite number expected"},
        Mistake{"ReloadWithoutFrom", "load_behavior 'lamp'  reload { form = 'off', to = 'on' }",
                "did you mean 'from'?"},
        Mistake{"StateOfAnUnknownMachine", "load_behavior 'lamp'  expect.state('lapm', 'off')",
                "behavior \"lapm\" is not loaded"},
        Mistake{"RequiredLibrary", "require 'lib.walk'",
                "require: a library runs only with a script that uses it (expected load_behavior or load_scenario)"},
        Mistake{"UnknownState", "load_behavior 'lamp'  expect.state('lamp', 'of')", "lamp: unknown state \"of\""},
        Mistake{"UnknownCommand", "expect.no_command('flip')", "unknown command 'flip' (did you mean"},
        Mistake{"UnknownLease", "expect.no_lease('pause_trainig')", "unknown pause 'pause_trainig'"}),
    [](const auto& each) { return std::string(each.param.name); });

TEST_F(ScriptedTests, AreRequiredInAFileOfTests) {
  run("local helper = 1\n");
  EXPECT_EQ(summary.failed, 1);
  EXPECT_NE(out.str().find("FAILED  tests/lamp_test.lua: declares a test\n"), std::string::npos) << out.str();
}

TEST_F(ScriptedTests, MayHaveAnyBytesInTheirNames) {
  run("test('a\\xff\\xc3\\x28\\x01<b>\\xef\\xbf\\xbf', function() expect.equal('\\x00\\x1b', '\"') end)");
  const std::string report = junit_report(summary, {});
  EXPECT_NE(report.find("name=\"a\\xFF\\xC3(\\x01&lt;b&gt;\\xEF\\xBF\\xBF\""), std::string::npos) << report;
  for (const char letter : report) EXPECT_TRUE(letter == '\n' || static_cast<unsigned char>(letter) >= ' ');
}

}  // namespace
}  // namespace reorient

// The runner of scripted tests: what it tells, what it counts, what it hands to CI.
#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"
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
    summary = run_script_tests({folder.path(), {}, std::move(simulate)}, out, trace);
    return summary;
  }
  std::string only_failure() {
    if (summary.cases.size() == 1 && summary.cases[0].failures.size() == 1) return summary.cases[0].failures[0].text;
    ADD_FAILURE() << out.str();
    return {};
  }
  std::string coverage() const {
    std::ostringstream text;
    report_coverage(trace, folder.path(), text);
    return text.str();
  }

  TemporaryFolder folder;
  std::ostringstream out;
  CoverageTrace trace;
  TestSummary summary;
};

TEST_F(ScriptedTests, TellEachFailureWithItsLineAndBothSides) {
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

TEST_F(ScriptedTests, ShowWhereTwoTablesDiffer) {
  run(R"(test("t", function()
  expect.equal({ a = 1, b = { "x", "y" }, extra = true }, { a = 1, b = { "x", "z" }, missing = 2 })
end))");
  const std::string text = only_failure();
  EXPECT_NE(text.find("at .b[2]: expected \"z\", actual \"y\""), std::string::npos) << text;
  EXPECT_NE(text.find("at .missing: expected 2, actual nil"), std::string::npos) << text;
  EXPECT_NE(text.find("at .extra: expected nothing, actual true"), std::string::npos) << text;
}

TEST_F(ScriptedTests, TakeTablesWithTheSameFieldsAsEqual) {
  run(R"(test("t", function() expect.equal({ 1, { x = 2.0 } }, { 1.0, { x = 2 } }) end))");
  EXPECT_EQ(summary.failed, 0) << out.str();
}

TEST_F(ScriptedTests, EndOnTablesThatHoldThemselves) {
  run(R"(test("t", function() local a, b = {}, {} a.a = a b.a = b expect.equal(a, b) end))");
  EXPECT_EQ(summary.failed, 1);
}

TEST_F(ScriptedTests, CountTheStatesAndTransitionsThatTheyTook) {
  run(R"(test("t", function() load_behavior "lamp" set_world { robot = { penalized = true } } advance(0.5) end))");
  EXPECT_EQ(coverage(),
            "lamp: 3 of 4 states, 1 of 3 transitions\n"
            "  behaviors/lamp.lua:8:11: never entered: on/bright\n"
            "  behaviors/lamp.lua:6:7: never taken: on > off (light)\n"
            "  behaviors/lamp.lua:7:21: never taken: on/dim > on/bright (after 1.0 s)\n");
}

TEST_F(ScriptedTests, CountBehaviorsThatNoTestLoads) {
  run(R"(test("t", function() end))");
  EXPECT_NE(coverage().find("lamp: 0 of 4 states, 0 of 3 transitions\n"), std::string::npos) << coverage();
}

TEST_F(ScriptedTests, CountWhatWasTakenAfterAnEditToo) {
  run(R"(test("t", function()
  load_behavior "lamp"
  advance(0.1)
  reload { from = "initial = \"off\"", to = "priority = 3, initial = \"off\"" }
  set_world { robot = { penalized = true } }
  advance(1.5)
  set_world { robot = { penalized = false } }
  advance(0.1)
end))");
  EXPECT_EQ(coverage(), "lamp: 4 of 4 states, 3 of 3 transitions\n") << out.str();
}

TEST_F(ScriptedTests, WriteAReportForCi) {
  run(R"(test("good", function() end) test("bad <&\">", function() expect.equal(1, 2) end))");
  EXPECT_EQ(junit_report(summary), R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuite name="reorient test" tests="2" failures="1" skipped="0">
  <testcase classname="tests/lamp_test.lua" name="good">
  </testcase>
  <testcase classname="tests/lamp_test.lua" name="bad &lt;&amp;&quot;&gt;">
    <failure message="tests/lamp_test.lua:1">expected 2
  actual 1</failure>
  </testcase>
</testsuite>
)");
}

TEST_F(ScriptedTests, AreSkippedVisiblyWhereTheyWantASimulatorAndThereIsNone) {
  run(R"(test("t", function() simulate { scenario = "s" } expect.equal(1, 2) end))");
  EXPECT_EQ(summary.skipped, 1);
  EXPECT_EQ(summary.failed, 0);
  EXPECT_NE(out.str().find("skipped tests/lamp_test.lua: t\n"), std::string::npos) << out.str();
  EXPECT_NE(junit_report(summary).find("<skipped/>"), std::string::npos);
}

TEST_F(ScriptedTests, ExpectOfASimulationWhatHappenedInAllOfIt) {
  SimulationRequest asked;
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
      [&](const SimulationRequest& request, CoverageTrace&) {
        asked = request;
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
  EXPECT_EQ(asked.scenario, "s");
  EXPECT_EQ(asked.with, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(asked.seed, 7U);
  EXPECT_EQ(asked.width, 320);
  EXPECT_EQ(asked.seconds, 12.5);
  EXPECT_FALSE(asked.room_awareness);
  std::sort(asked.parameters.begin(), asked.parameters.end());
  EXPECT_EQ(asked.parameters,
            (std::vector<std::pair<std::string, std::string>>{{"lamp.level", "0.5"}, {"lamp.on", "true"}}));
}

TEST_F(ScriptedTests, FailWhenASimulationsScriptDoes) {
  run(R"(test("t", function() simulate { scenario = "s" } end))", [](const SimulationRequest&, CoverageTrace&) {
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

TEST_F(ScriptedTests, RefuseSimulationsThatMakeNoSense) {
  for (const BadRequest& bad :
       {BadRequest{"{}", "needs a scenario"}, BadRequest{"{ scenari = 'x' }", "did you mean 'scenario'"},
        BadRequest{"{ scenario = 'x', seed = -1 }", "seed"}, BadRequest{"{ scenario = 'x', seed = 1.5 }", "seed"},
        BadRequest{"{ scenario = 'x', width = 100 }", "width"}, BadRequest{"{ scenario = 'x', with = 'a' }", "with"},
        BadRequest{"{ scenario = 'x', with = { 1 } }", "with"},
        BadRequest{"{ scenario = 'x', seconds = 0/0 }", "seconds"},
        BadRequest{"{ scenario = 'x', params = { 1 } }", "params"}, BadRequest{"'x'", "table"}}) {
    run(std::string("test(\"t\", function() simulate(") + bad.table + ") end)",
        [](const SimulationRequest&, CoverageTrace&) { return SimulationOutcome{}; });
    EXPECT_EQ(summary.failed, 1) << bad.table;
    EXPECT_NE(out.str().find(bad.message), std::string::npos) << bad.table << "\n" << out.str();
  }
}

}  // namespace
}  // namespace reorient

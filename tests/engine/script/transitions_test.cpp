// SPDX-License-Identifier: MIT
// Transitions, dwell times and nested states, frame by frame.
#include <array>
#include <cstdio>

#include "tests/engine/script/script_fixture.h"

namespace reorient {
namespace {

class ScriptTransitions : public ScriptTest {
 protected:
  /// "from -> to" of all transitions so far.
  std::vector<std::string> steps() const {
    std::vector<std::string> all;
    for (const TickedTransition& record : transitions) all.push_back(record.from + " -> " + record.to);
    return all;
  }
};

using Steps = std::vector<std::string>;

/// The possible transitions as texts: "from -> to: result held/lasting waited/after".
class ScriptConditions : public ScriptTest {
 protected:
  std::vector<std::string> open() {
    constexpr const char* kWhen[] = {"timed", "unasked", "no", "yes", "failed"};
    std::vector<OpenCondition> all;
    host().read_conditions(all);
    const Names& names = host().names();
    const auto dwell = [](double so_far, double needed) {
      std::array<char, 32> text{};
      std::snprintf(text.data(), text.size(), " %.1f/%.1f", so_far, needed);
      return std::string(text.data());
    };
    std::vector<std::string> texts;
    texts.reserve(all.size());
    for (const OpenCondition& one : all)
      texts.push_back(names[one.from] + " -> " + names[one.target] + ": " + kWhen[static_cast<std::size_t>(one.when)] +
                      dwell(one.held, one.lasting) + dwell(one.waited, one.after));
    return texts;
  }
};

TEST_F(ScriptConditions, AreListedWithResultAndDuration) {
  load("b", R"(local p = param { wait = { 2, range = { 0, 5 }, doc = "x" } }
    behavior "b" { initial = "one",
      common = { { "three", when = function() return robot.posture == "lying" end } },
      state "one" {
        { "two", when = function() return robot.penalized end, lasting = "wait" },
        { "three", after = 3 },
      },
      state "two" {}, state "three" {} })");
  tick();
  EXPECT_EQ(open(), (Steps{" -> three: unasked 0.0/0.0 0.0/0.0", "one -> two: unasked 0.0/2.0 0.0/0.0",
                           "one -> three: timed 0.0/0.0 0.0/3.0"}));
  ticks(30);
  EXPECT_EQ(open(), (Steps{" -> three: no 0.0/0.0 1.0/0.0", "one -> two: no 0.0/2.0 1.0/0.0",
                           "one -> three: timed 0.0/0.0 1.0/3.0"}));
  world.referee.penalized = true;
  ticks(16);
  EXPECT_EQ(open()[1], "one -> two: yes 0.5/2.0 1.5/0.0");
  ticks(45);
  EXPECT_EQ(state("b"), "three");
  EXPECT_EQ(open(), Steps()) << "the target is active, and the state has no transitions";
}

TEST_F(ScriptConditions, ShowTheLastResultOfADwellFunction) {
  load("b", R"(behavior "b" { initial = "one",
    state "one" { { "two", when = function() return robot.penalized end, lasting = function() return 3 end } },
    state "two" {} })");
  ticks(2);
  EXPECT_EQ(open(), (Steps{"one -> two: no 0.0/nan 0.0/0.0"}));
  world.referee.penalized = true;
  ticks(2);
  EXPECT_EQ(open(), (Steps{"one -> two: yes 0.0/3.0 0.1/0.0"}));
}

TEST_F(ScriptConditions, ThatFailAreListedAsFailed) {
  load("b", R"(behavior "b" { initial = "one",
    state "one" {
      { "two", when = function() return robot.penalized end },
      { "two", when = function() return nil + 1 end },
      { "two", when = function() return true end, lasting = function() return -1 end },
    }, state "two" {} })");
  ticks(2);
  EXPECT_EQ(open(), (Steps{"one -> two: no 0.0/0.0 0.0/0.0", "one -> two: failed 0.0/0.0 0.0/0.0",
                           "one -> two: unasked 0.0/nan 0.0/0.0"}));
}

TEST_F(ScriptConditions, AreListedWithoutCallingTheScript) {
  load("b", R"(local memory = keep { asked = 0 }
    behavior "b" { initial = "one",
      state "one" {
        update = function() log.info(tostring(memory.asked)) end,
        { "two", when = function() memory.asked = memory.asked + 1 return false end },
      }, state "two" {} })");
  for (int i = 0; i < 10; ++i) {
    tick();
    open();
    open();
  }
  EXPECT_EQ(logs.back(), "9");
}

TEST_F(ScriptTransitions, ACommandCarriesItsIssuerStateReasonAndPriority) {
  load("b", R"(behavior "b" { priority = 50, initial = "one",
    state "one" { { "two", when = function() return robot.penalized end, because = "it fell" } },
    state "two" { enter = command.flip_pose } })");
  tick();
  EXPECT_TRUE(commands.empty());
  world.referee.penalized = true;
  tick();
  ASSERT_EQ(commands.size(), 1u);
  EXPECT_EQ(commands[0].reorientation, Reorientation::flip_pose);
  EXPECT_EQ(commands[0].machine, "b");
  EXPECT_EQ(commands[0].state, "two");
  EXPECT_EQ(commands[0].reason, "it fell");
  EXPECT_EQ(commands[0].priority, 50.0);
}

TEST_F(ScriptTransitions, AMachineTakesOneTransitionPerFrame) {
  load("b", R"(local function yes() return true end
    behavior "b" { initial = "one", state "one" { { "two", when = yes } }, state "two" { { "three", when = yes } },
      state "three" { { "one", when = yes } } })");
  ticks(4);
  EXPECT_EQ(steps(), (Steps{" -> one", "one -> two", "two -> three", "three -> one"}));
}

TEST_F(ScriptTransitions, LastingRequiresTheConditionWithoutInterruption) {
  load("b", R"(behavior "b" { initial = "one",
    state "one" { { "two", when = function() return robot.penalized end, lasting = 0.5 } }, state "two" {} })");
  world.referee.penalized = true;
  ticks(12);
  world.referee.penalized = false;
  ticks(1);
  world.referee.penalized = true;
  ticks(15);
  EXPECT_EQ(state("b"), "one");
  ticks(1);
  EXPECT_EQ(state("b"), "two");
}

TEST_F(ScriptTransitions, AfterCountsFromTheEntryOfItsState) {
  load(
      "b",
      R"(behavior "b" { initial = "one", state "one" { { "two", after = 1 } }, state "two" { { "one", after = 0.5 } } })");
  ticks(30);
  EXPECT_EQ(state("b"), "one");
  ticks(1);
  EXPECT_EQ(state("b"), "two");
  ticks(14);
  EXPECT_EQ(state("b"), "two");
  ticks(1);
  EXPECT_EQ(state("b"), "one");
}

TEST_F(ScriptTransitions, DwellMayBeAParameterOrAFunction) {
  load("b", R"(local p = param { wait = { 1.0, range = { 0, 5 }, doc = "x" } }
    behavior "b" { initial = "one", state "one" { { "two", after = "wait" } },
      state "two" { { "one", after = function() return p.wait / 2 end } } })");
  parameters.set("b.wait", "0.2", ParameterOrigin::live);
  ticks(7);
  EXPECT_EQ(state("b"), "two");
  ticks(3);
  EXPECT_EQ(state("b"), "one");
}

TEST_F(ScriptTransitions, CommonIsCheckedFirstAndNotWhileItsTargetIsActive) {
  load("b", R"(behavior "b" { initial = "one", common = { { "down", when = function() return robot.penalized end } },
    state "one" { { "two", when = function() return true end } }, state "two" {}, state "down" { enter = function() log.info("down") end } })");
  tick();
  world.referee.penalized = true;
  ticks(5);
  EXPECT_EQ(steps(), (Steps{" -> one", "one -> down"}));
  EXPECT_EQ(logs, std::vector<std::string>{"down"});
}

TEST_F(ScriptTransitions, NestedStatesAreEnteredFromOutsideAndLeftFromInside) {
  load("b", R"(local function say(text) return function() log.info(text) end end
    behavior "b" { initial = "outer",
      state "outer" { initial = "inner", enter = say "+outer", exit = say "-outer", update = say "outer",
        { "other", after = 0.1 },
        state "inner" { enter = say "+inner", exit = say "-inner", update = say "inner" } },
      state "other" { enter = say "+other" } })");
  ticks(4);
  EXPECT_EQ(logs, (std::vector<std::string>{"+outer", "+inner", "outer", "inner", "outer", "inner", "outer", "inner",
                                            "-inner", "-outer", "+other"}));
  EXPECT_EQ(steps(), (Steps{" -> outer/inner", "outer/inner -> other"}));
}

TEST_F(ScriptTransitions, AnInnerTransitionDoesNotReenterTheOuterState) {
  load("b",
       R"(behavior "b" { initial = "outer", state "outer" { initial = "x", enter = function() log.info("+outer") end,
    update = function() log.info(string.format("%.1f", time_in_state())) end,
    state "x" { { "y", after = 0.1 } }, state "y" { { "z", after = 0.1 } } }, state "z" {} })");
  ticks(5);
  EXPECT_EQ(state("b"), "outer/y");
  EXPECT_EQ(logs, (std::vector<std::string>{"+outer", "0.0", "0.0", "0.1", "0.1", "0.1"}));
  ticks(3);
  EXPECT_EQ(state("b"), "z");
}

TEST_F(ScriptTransitions, HistoryResumesTheLastInnerState) {
  load("b", R"(behavior "b" { initial = "outer", common = { { "down", when = function() return robot.penalized end } },
    state "outer" { initial = "x", history = true, state "x" { { "y", after = 0.1 } }, state "y" {} },
    state "down" { { "outer", when = function() return not robot.penalized end } } })");
  ticks(5);
  EXPECT_EQ(state("b"), "outer/y");
  world.referee.penalized = true;
  tick();
  world.referee.penalized = false;
  tick();
  EXPECT_EQ(state("b"), "outer/y");
}

TEST_F(ScriptTransitions, ATransitionToItselfEntersAgain) {
  load(
      "b",
      R"(behavior "b" { initial = "one", state "one" { enter = function() log.info("+") end, { "one", after = 0.1 } } })");
  ticks(10);
  EXPECT_EQ(logs.size(), 4u);
}

TEST_F(ScriptTransitions, APauseLastsAsLongAsItsState) {
  load("b", R"(behavior "b" { initial = "one",
    state "one" { enter = command.pause_training, { "two", after = 0.1, because = "enough" } },
    state "two" { enter = command.pause_evaluation } })");
  for (int i = 0; i < 3; ++i) {
    const SeenTick& output = tick();
    ASSERT_EQ(output.leases.size(), 1u);
    EXPECT_EQ(output.leases[0].pause, Pause::training);
    EXPECT_EQ(output.leases[0].state, "one");
    EXPECT_EQ(output.leases[0].reason, "start");
  }
  const SeenTick& output = tick();
  ASSERT_EQ(output.leases.size(), 1u);
  EXPECT_EQ(output.leases[0].pause, Pause::evaluation);
  EXPECT_EQ(output.leases[0].reason, "enough");
}

TEST_F(ScriptTransitions, TheGreaterPriorityWinsEachChannel) {
  load("low", R"(behavior "low" { priority = 1, update = function() head.look(0.1, 0) walk.velocity(0.1, 0, 0) end })");
  load("high", R"(behavior "high" { priority = 2, update = function() head.look(0.2, 0, 2.0) end })");
  load("same", R"(behavior "same" { priority = 2, update = function() head.look(0.3, 0) end })");
  const Request& request = tick().request;
  ASSERT_TRUE(request.head.has_value());
  EXPECT_EQ(request.head->angles.yaw, 0.2);
  EXPECT_EQ(request.head->speed, 2.0);
  EXPECT_EQ(request.walk.forward, 0.1);
  EXPECT_FALSE(request.get_up);
}

TEST_F(ScriptTransitions, ARequestIsValidForOneFrame) {
  load(
      "b",
      R"(behavior "b" { initial = "one", enter = function() head.look(0, 0) walk.velocity(0.1, 0, 0) end, state "one" {} })");
  EXPECT_TRUE(tick().request.head.has_value());
  const Request& second = tick().request;
  EXPECT_FALSE(second.head.has_value());
  EXPECT_EQ(second.walk.forward, 0.0);
}

TEST_F(ScriptTransitions, BehaviorsReadEachOthersStateAtTheStartOfTheFrame) {
  load("a", R"(behavior "a" { initial = "one", state "one" { { "two", after = 0.1 } }, state "two" {} })");
  load("b", R"(behavior "b" { update = function() log.info(behaviors.a.state) end })");
  ticks(5);
  EXPECT_EQ(logs, (std::vector<std::string>{"", "one", "one", "one", "two"}));
}

TEST_F(ScriptTransitions, ABehaviorThatDoesNotRunHasNoState) {
  load("b", R"(behavior "b" { update = function()
    log.info(tostring(behaviors.a.state) .. " " .. tostring(behaviors.a.time_in_state > 1))
  end })");
  tick();
  load("a", R"(behavior "a" { initial = "one", state "one" {} })");
  ticks(2);
  EXPECT_TRUE(faults.empty());
  EXPECT_EQ(logs, (std::vector<std::string>{"nil false", " false", "one false"}));
}

TEST_F(ScriptTransitions, AConditionMustNotAct) {
  load(
      "b",
      R"(behavior "b" { initial = "one", state "one" { { "two", when = function() command.flip_pose() return true end } }, state "two" {} })");
  ticks(2);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].fault.message.find("not allowed in a condition"), std::string::npos);
  EXPECT_TRUE(commands.empty());
}

TEST_F(ScriptTransitions, AnErrorInALibrarysStateIsReportedAtItsPosition) {
  folder.write("lib/states.lua", R"(return {
  pause = function() return state "pause" { { "nowhere", after = 1 } } end,
})");
  const ScriptFault fault = refusal(R"(local states = require "lib.states"
behavior "refused" { state "a" { states.pause() } })");
  EXPECT_EQ(fault.text(), "lib/states.lua:2:47: state 'a/pause': unknown target state 'nowhere'") << fault.text();
}

TEST_F(ScriptTransitions, AnInvalidTimeInALibrarysStateIsReportedThere) {
  folder.write("lib/states.lua", R"(return {
  pause = function() return state "pause" { { "pause", after = function() return "long" end } } end,
})");
  load("waits", "local states = require \"lib.states\"\n\n\nbehavior \"waits\" { states.pause() }");
  ticks(2);
  ASSERT_FALSE(faults.empty());
  EXPECT_EQ(faults.front().fault.file, "lib/states.lua");
  EXPECT_EQ(faults.front().fault.line, 2);
}

TEST_F(ScriptTransitions, ATransitionKnowsTheLibraryWhoseFunctionMadeIt) {
  folder.write("lib/ways.lua", R"(return {
  is_down = function() return false end,
  to = function(target) return { target, when = function() return true end } end,
})");
  load("made", R"(local ways = require "lib.ways"
behavior "made" {
  initial = "a",
  state "a" { { "b", when = ways.is_down }, ways.to("b") },
  state "b" {},
})");
  const std::vector<TransitionDefinition>& made = host().definitions().front()->transitions;
  ASSERT_EQ(made.size(), 2U);
  EXPECT_EQ(made[0].maker, "") << "only its condition is from the library";
  EXPECT_EQ(made[1].maker, "lib/ways.lua");
}

TEST_F(ScriptTransitions, AFileMayDeclareSeveralMachines) {
  load(
      "b",
      R"(behavior "left" { update = function() log.info("left") end } behavior "right" { update = function() log.info("right") end })");
  tick();
  EXPECT_EQ(logs, (std::vector<std::string>{"left", "right"}));
}

struct Mistake {
  const char* name;
  const char* text;
  int line;
  const char* message;
};

class MistakenDeclaration : public ScriptTest, public ::testing::WithParamInterface<Mistake> {};

TEST_P(MistakenDeclaration, IsRefusedWithItsLineAndASuggestion) {
  const ScriptFault fault = refusal(GetParam().text);
  EXPECT_NE(fault.message.find(GetParam().message), std::string::npos) << fault.message;
  EXPECT_EQ(fault.line, GetParam().line) << fault.message;
  EXPECT_EQ(fault.file, "behaviors/refused.lua");
}

INSTANTIATE_TEST_SUITE_P(
    Mistakes, MistakenDeclaration,
    ::testing::Values(
        Mistake{"SyntaxError", "behavior \"b\" {\n  initial = \n}", 3, "unexpected symbol"},
        Mistake{"Nothing", "local x = 1", 1, "missing declaration"},
        Mistake{"UnknownTarget",
                "behavior \"b\" { initial = \"watching\",\n state \"watching\" {\n  { \"corecting\", after = 1 } },\n "
                "state \"correcting\" {} }",
                3, "unknown target state 'corecting' (did you mean 'correcting'?)"},
        Mistake{"UnknownInitial", "behavior \"b\" { initial = \"wathcing\", state \"watching\" {}, state \"b\" {} }", 1,
                "did you mean 'watching'"},
        Mistake{"NoInitial", "behavior \"b\" { state \"a\" {}, state \"b\" {} }", 1, "no initial state"},
        Mistake{"DuplicateState", "behavior \"b\" { initial = \"a\",\n state \"a\" {},\n state \"a\" {} }", 3,
                "duplicate state 'a'"},
        Mistake{"UnprintableState", "behavior \"b\" {\n state \"\\27[2J\" {} }", 2, "printable UTF-8 text"},
        Mistake{"StateOfBytes", "behavior \"b\" {\n state \"\\xFF\" {} }", 2, "printable UTF-8 text"},
        Mistake{"NoCondition", "behavior \"b\" { state \"a\" { { \"a\" } } }", 1, "without a condition"},
        Mistake{"LastingWithoutWhen", "behavior \"b\" { state \"a\" { { \"a\", lasting = 1 } } }", 1,
                "'lasting' requires 'when'"},
        Mistake{"UnknownDwell",
                "param { settle = { 1, range = { 0, 2 }, doc = \"x\" } }\nbehavior \"b\" { state \"a\" { { \"a\", "
                "after = \"setle\" } } }",
                2, "unknown param 'setle' (did you mean 'settle'?)"},
        Mistake{"UnknownKey", "behavior \"b\" {\n state \"a\" { entre = print } }", 2,
                "unknown key 'entre' (did you mean 'enter'?)"},
        Mistake{"NotAFunction", "behavior \"b\" { enter = 5 }", 1, "enter: expected a function, found a number"},
        Mistake{"NegativeDwell", "behavior \"b\" { state \"a\" { { \"a\", after = -1 } } }", 1, "non-negative"},
        Mistake{"UnknownGlobal", "\nbehavor \"b\" {}", 2, "unknown name 'behavor' (did you mean 'behavior'?)"},
        Mistake{"TwoMachinesOfAName", "behavior \"b\" {}\nbehavior \"b\" {}", 2, "declared twice"},
        Mistake{"ParamWithoutSentence", "param { x = { 1, range = { 0, 1 } } }", 1, "missing description"},
        Mistake{"ParamOutOfItsRange", "param { x = { 5, range = { 0, 1 }, doc = \"x\" } }", 1, "expected 0 to 1"},
        Mistake{"ParamWithoutRange", "param { x = { 5, doc = \"x\" } }", 1, "missing range"},
        Mistake{"EmptyRange", "param { x = { 5, range = { 1, 0 }, doc = \"x\" } }", 1, "is empty"},
        Mistake{"ScenarioWord", "scenario \"b\" {}", 1, "unknown name 'scenario'"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

}  // namespace
}  // namespace reorient

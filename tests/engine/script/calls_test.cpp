// SPDX-License-Identifier: MIT
// Behaviors that run others: arguments, ends, reloads, saved state, and wrong calls.
#include "geometry/bytes.h"
#include "tests/engine/script/script_fixture.h"

namespace reorient {
namespace {

const std::string kWalkTo = R"(
local a = args {
  distance = { 1.0, range = { 0, 10 }, unit = "m", doc = "way to go" },
  foot = { "left", choices = { "left", "right" }, doc = "first foot" },
  timeout = { 5.0, range = { 0, 60 }, unit = "s", doc = "time after which it gives up" },
}
behavior "walk_to" { priority = 1, initial = "walking",
  state "walking" {
    enter = function() log.info("walks " .. a.distance .. " " .. a.foot) end,
    update = function() walk.velocity(a.distance, 0, 0) end,
    exit = function() log.info("stops") end,
    { "arrived", when = function() return a.distance < 0.2 end, because = "it is near" },
    { "given up", after = "timeout", because = "it took too long" },
  },
  state "arrived" { ends = "done" },
  state "given up" { ends = "failed" },
}
)";

/// A caller in whose state the behavior runs. `call`: what follows `run "walk_to"`.
std::string player(const std::string& call) {
  return R"(local far = keep { distance = 3.0 }
behavior "player" { priority = 30, initial = "going",
  state "going" {
    run "walk_to" )" +
         call + R"(,
    { "there", when = done "walk_to", because = "it has arrived" },
    { "lost", when = failed "walk_to", because = "it did not arrive" },
  },
  state "there" { { "going", after = 0.5 } },
  state "lost" {},
})";
}

class ScriptCalls : public ScriptTest {
 protected:
  void write(const std::string& name, const std::string& text) { folder.write("behaviors/" + name + ".lua", text); }
  void load_player(const std::string& call) {
    write("walk_to", kWalkTo);
    load("player", player(call));
  }
  std::vector<std::string> entered(const std::string& machine) const {
    std::vector<std::string> all;
    for (const TickedTransition& transition : transitions) {
      if (transition.machine == machine) all.push_back(transition.to);
    }
    return all;
  }
};

TEST_F(ScriptCalls, ABehaviorRunsAnotherWithArguments) {
  load_player(R"({ distance = 2.5, foot = "right" })");
  const SeenTick& seen = tick();
  EXPECT_EQ(state("player"), "going");
  EXPECT_EQ(state("player/walk_to"), "walking");
  EXPECT_EQ(logs, std::vector<std::string>{"walks 2.5 right"});

  EXPECT_DOUBLE_EQ(seen.request.walk.forward, 2.5);
}

TEST_F(ScriptCalls, MissingArgumentsHaveTheirDefaults) {
  load_player("{}");
  tick();
  EXPECT_EQ(logs, std::vector<std::string>{"walks 1.0 left"});
}

TEST_F(ScriptCalls, AFunctionGivesTheArgumentOfEachFrame) {
  write("walk_to", kWalkTo);
  load("player", player("{ distance = function() far.distance = far.distance - 1.0 return far.distance end }"));
  tick();
  EXPECT_EQ(logs.back(), "walks 2.0 left");
  EXPECT_DOUBLE_EQ(tick().request.walk.forward, 1.0);
  tick();  // 0.0: near
  EXPECT_EQ(state("player/walk_to"), "arrived");
  EXPECT_EQ(state("player"), "going") << "its caller sees the end in the next frame";
  tick();
  EXPECT_EQ(state("player"), "there");
  EXPECT_EQ(transitions.back().reason, "its caller has left the state");
  EXPECT_EQ(state("player/walk_to"), "");
}

TEST_F(ScriptCalls, ACallStartsAgainWithEachVisit) {
  load_player("{ distance = 0.1 }");
  ticks(60);
  const std::vector<std::string> walked = entered("player/walk_to");
  ASSERT_GT(walked.size(), 5u);
  EXPECT_EQ((std::vector<std::string>(walked.begin(), walked.begin() + 5)),
            (std::vector<std::string>{"walking", "arrived", "", "walking", "arrived"}));
}

TEST_F(ScriptCalls, AnArgumentCanBeADwellTime) {
  load_player("{ timeout = 0.5 }");
  ticks(16);
  EXPECT_EQ(state("player/walk_to"), "given up");
  tick();
  EXPECT_EQ(state("player"), "lost");
}

TEST_F(ScriptCalls, ACalledBehaviorHasThePriorityOfItsCaller) {
  write("walk_to", kWalkTo);
  load("player", player("{ distance = 2 }"));
  load("other", R"(behavior "other" { priority = 20, initial = "a",
    state "a" { update = function() walk.velocity(9, 0, 0) end } })");
  EXPECT_DOUBLE_EQ(tick().request.walk.forward, 2.0);
  std::string lower = player("{ distance = 2 }");
  edit("player", lower.replace(lower.find("30"), 2, "10"));
  EXPECT_DOUBLE_EQ(tick().request.walk.forward, 9.0);
}

TEST_F(ScriptCalls, TheCallersOwnRequestIsFirst) {
  write("walk_to", kWalkTo);
  load("player", R"(behavior "player" { initial = "a",
    state "a" { run "walk_to" { distance = 2 }, update = function() walk.velocity(1, 0, 0) end } })");
  EXPECT_DOUBLE_EQ(tick().request.walk.forward, 1.0);
}

TEST_F(ScriptCalls, HeadAndLegsRunInParallelAndEndWithTheState) {
  write("walk_to", kWalkTo);
  write("look", R"(behavior "look" { initial = "looking",
    state "looking" { enter = command.pause_training, update = function() head.look(0.5, 0) end, exit = function() log.info("looked") end } })");
  load("player", R"(behavior "player" { initial = "a",
    state "a" { run "walk_to" { distance = 2 }, run "look" {}, { "b", after = 0.1 } }, state "b" {} })");
  const SeenTick& seen = tick();
  EXPECT_NE(seen.request.walk.forward, 0.0);
  EXPECT_TRUE(seen.request.head);
  ASSERT_EQ(seen.leases.size(), 1u);
  EXPECT_EQ(seen.leases[0].machine, "player/look");
  ticks(4);
  EXPECT_EQ(state("player"), "b");
  EXPECT_EQ((std::vector<std::string>(logs.end() - 2, logs.end())), (std::vector<std::string>{"stops", "looked"}));
  const SeenTick& after = tick();
  EXPECT_EQ(after.request.walk.forward, 0.0);
  EXPECT_FALSE(after.request.head);
  EXPECT_TRUE(after.leases.empty());
}

TEST_F(ScriptCalls, NestedCallsStopTogether) {
  write("walk_to", kWalkTo);
  write("approach", R"(behavior "approach" { initial = "near",
    state "near" { run "walk_to" { distance = 2 }, exit = function() log.info("leaves") end } })");
  load("player", R"(behavior "player" { initial = "a",
    state "a" { run "approach" {}, { "b", after = 0.1 } }, state "b" {} })");
  tick();
  EXPECT_EQ(state("player/approach/walk_to"), "walking");
  ticks(4);
  EXPECT_EQ(state("player/approach"), "");
  EXPECT_EQ(state("player/approach/walk_to"), "");
  EXPECT_EQ(logs.back(), "stops");
}

TEST_F(ScriptCalls, AScriptReadsWhatItRuns) {
  write("walk_to", kWalkTo);
  load("player", R"(behavior "player" { initial = "a",
    state "a" { run "walk_to" { timeout = 0.1 },
      update = function()
        local it = called.walk_to
        log.info(it.outcome .. "," .. it.state .. "," .. it.reason)
      end,
      { "b", when = function() return called.walk_to.outcome == "failed" end } },
    state "b" { update = function() log.info(called.walk_to.outcome .. "," .. called.walk_to.reason .. "," .. tostring(called.walk_to.state)) end,
      { "a", after = 0.1 } } })");
  tick();
  EXPECT_EQ(logs.front(), "running,,") << "its caller is first";
  tick();
  EXPECT_EQ(logs.back(), "running,walking,start");
  ticks(4);
  EXPECT_EQ(state("player"), "b");
  EXPECT_EQ(logs.back(), "failed,it took too long,nil") << "so that the next state can say why";
  for (int i = 0; i < 10 && state("player") != "a"; ++i) tick();
  EXPECT_EQ(state("player"), "a");
  EXPECT_EQ(logs[logs.size() - 2], "running,,") << "it starts again, after its caller";
}

TEST_F(ScriptCalls, AResultOutsideOfItsRangeIsLimited) {
  load_player("{ distance = function() return 1000 end }");
  EXPECT_DOUBLE_EQ(tick().request.walk.forward, 10.0);
  EXPECT_TRUE(faults.empty());
}

TEST_F(ScriptCalls, AResultOfAWrongTypeIsAnErrorOfTheCaller) {
  load_player("{ distance = 1 }");
  for (const std::string result : {"nil", "0 / 0", "\"far\"", "{}", "error(\"broken\")"}) {
    ASSERT_TRUE(edit("player", player("{ distance = function() return " + result + " end }")).accepted);
    const SeenTick& seen = tick();
    ASSERT_EQ(seen.faults.size(), 1u) << result;
    EXPECT_EQ(seen.faults[0].script, "behaviors/player.lua");
    EXPECT_EQ(seen.faults[0].fault.line, 4) << seen.faults[0].fault.text();
    EXPECT_EQ(seen.request.walk.forward, 0.0) << "the callee does not run with a wrong argument";
    edit("player", player("{ distance = 1 }"));
    tick();
  }
}

TEST_F(ScriptCalls, ACalledBehaviorIsReloadedWhileItRuns) {
  load_player("{ distance = 2 }");
  ticks(10);
  std::string faster = kWalkTo;
  const ReloadRecord report = edit("walk_to", faster.replace(faster.find("velocity(a.distance"), 19, "velocity(7"));
  EXPECT_TRUE(report.accepted) << report.fault.text();
  const std::size_t before = transitions.size();
  EXPECT_DOUBLE_EQ(tick().request.walk.forward, 7.0);
  EXPECT_EQ(transitions.size(), before) << "it continues in its state";
}

TEST_F(ScriptCalls, AReloadedCallerKeepsWhatItRuns) {
  load_player("{ distance = 2 }");
  ticks(10);
  const std::size_t before = transitions.size();
  EXPECT_TRUE(edit("player", player("{ distance = 3 }")).accepted);
  EXPECT_DOUBLE_EQ(tick().request.walk.forward, 3.0);
  EXPECT_EQ(transitions.size(), before);
}

TEST_F(ScriptCalls, ACallerMayRunAnotherBehaviorAfterAReload) {
  load_player("{ distance = 2 }");
  tick();
  write("look", R"(behavior "look" { initial = "a", state "a" { update = function() head.look(0.5, 0) end } })");
  EXPECT_TRUE(edit("player", R"(behavior "player" { initial = "going", state "going" { run "look" {} } })").accepted);
  const SeenTick& seen = tick();
  EXPECT_EQ(seen.request.walk.forward, 0.0);
  EXPECT_TRUE(seen.request.head);
  EXPECT_EQ(host().definitions().size(), 2u);
}

TEST_F(ScriptCalls, ACallerIsNotReloadedWithoutWhatItRuns) {
  load_player("{ distance = 2 }");
  tick();
  const ReloadRecord report = edit("player", R"(behavior "player" { initial = "a", state "a" { run "walk_too" {} } })");
  EXPECT_FALSE(report.accepted);
  EXPECT_EQ(report.fault.text(),
            "behaviors/player.lua:1:52: run \"walk_too\": script not found (did you mean 'behaviors/walk_to.lua'?)");
  EXPECT_DOUBLE_EQ(tick().request.walk.forward, 2.0);
  write("walk_too",
        R"(behavior "walk_too" { initial = "a", state "a" { update = function() walk.velocity(5, 0, 0) end } })");
  EXPECT_EQ(reload().size(), 1u) << "the missing file has appeared";
  EXPECT_DOUBLE_EQ(tick().request.walk.forward, 5.0);
}

TEST_F(ScriptCalls, AnArgumentThatItsCallerGivesCannotBeRemoved) {
  load_player("{ distance = 2, foot = \"right\" }");
  tick();
  std::string other = kWalkTo;
  other.replace(other.find("foot = "), 5, "side ");
  other.replace(other.find("a.foot"), 6, "a.side");
  const ReloadRecord refused = edit("walk_to", other);
  EXPECT_FALSE(refused.accepted);
  EXPECT_EQ(refused.fault.message, "run \"walk_to\": unknown argument 'foot'");
  EXPECT_EQ(refused.fault.file, "behaviors/player.lua");
  write("player", player("{ distance = 2 }"));
  const std::vector<ReloadRecord> both = reload();
  ASSERT_EQ(both.size(), 2u) << "the refused version gets another chance";
  EXPECT_TRUE(both[0].accepted && both[1].accepted) << both[1].fault.text();
}

TEST_F(ScriptCalls, AStoppedCalleeHasFailed) {
  write("walk_to", R"(behavior "walk_to" { initial = "a", state "a" { update = function() error("broken") end } })");
  load("player", player("{}"));
  ticks(limits.max_errors + 2);
  EXPECT_TRUE(status("player/walk_to").stopped);
  EXPECT_FALSE(status("player").stopped);
  EXPECT_EQ(state("player"), "lost");
}

TEST_F(ScriptCalls, ARollbackBringsBackWhatTheVersionBeforeRan) {
  load_player("{ distance = 2 }");
  ticks(static_cast<int>(limits.trial_time / kStep) + 2);
  EXPECT_TRUE(edit("player", R"(behavior "player" { initial = "going",
    state "going" { update = function() error("broken") end } })")
                  .accepted);
  ticks(limits.max_errors + 1);
  EXPECT_EQ(faults.back().consequence, FaultRecord::Consequence::rolled_back);
  EXPECT_DOUBLE_EQ(tick().request.walk.forward, 2.0);
}

TEST_F(ScriptCalls, TheSavedStateContinuesInTheSameFrame) {
  load_player("{ distance = 2, timeout = 1.0 }");
  ticks(20);
  std::vector<std::byte> bytes;
  ByteWriter out(bytes);
  host().save(out);
  std::vector<std::string> expected;
  for (int i = 0; i < 30; ++i) {
    for (const TickedTransition& one : tick().transitions) expected.push_back(one.machine + ":" + one.to);
  }
  EXPECT_FALSE(expected.empty());
  Behaviors restored{ScriptTexts(), parameters, limits};
  ByteReader in(bytes);
  restored.host().restore(in);
  World again = world;
  again.time -= 30 * kStep;
  std::vector<std::string> found;
  for (int i = 0; i < 30; ++i, again.time += kStep) {
    restored.tick(again);
    const Names& names = restored.host().names();
    for (const TransitionRecord& one : restored.said().transitions)
      found.push_back(names[one.machine] + ":" + names[one.to]);
  }
  EXPECT_EQ(found, expected);
}

TEST_F(ScriptCalls, ABehaviorThatWasLoadedByNameHasDefaultsAndStaysInItsEnd) {
  load("walk_to", kWalkTo);
  ticks(200);
  EXPECT_EQ(state("walk_to"), "given up");
}

TEST_F(ScriptCalls, OneBehaviorRunsForSeveralCallersAndByItself) {
  write("walk_to", kWalkTo);
  load("player", player("{ distance = 2 }"));
  load("second", R"(behavior "second" { priority = 50, initial = "a", state "a" { run "walk_to" { distance = 4 } } })");
  host().load("walk_to");
  EXPECT_DOUBLE_EQ(tick().request.walk.forward, 4.0);
  EXPECT_EQ(host().definitions().size(), 5u);
  EXPECT_EQ(logs.size(), 3u);
}

struct WrongCall {
  const char* text;
  const char* message;
};

TEST_F(ScriptCalls, WrongCallsAreRefusedWithOneLine) {
  const WrongCall wrong[] = {
      {R"(state "a" { run "walk_to" { distence = 1 } })", "unknown argument 'distence' (did you mean 'distance'?)"},
      {R"(state "a" { run "walk_to" { distance = 11 } })", "distance: expected 0 to 10 m, found 11"},
      {R"(state "a" { run "walk_to" { distance = "x" } })", "distance: expected a number, found x"},
      {R"(state "a" { run "walk_to" { foot = "both" } })", "foot: expected left, right, found both"},
      {R"(state "a" { run "walk_to" { foot = 1 } })", "foot: expected a string, found 1"},
      {R"(state "a" { run "walk_to" { distance = {} } })",
       "distance: expected a number, a boolean, a string, or a function"},
      {R"(state "a" { run "walk_to" { 1.0 } })", "expected named arguments, as in { x = 1.0 }"},
      {R"(state "a" { run "walk_to" })", "a state or a run ends with a table: run \"walk_to\" { }"},
      {R"(state "a" { run "walk to" {} })", "run: expected the name of a behavior, found 'walk to'"},
      {R"(state "a" { run "refused" {} })", "run \"refused\": it runs itself: refused/refused"},
      {R"(state "a" { run "walk_to" {}, run "walk_to" {} })", "'walk_to' already runs in state 'a'"},
      {R"(state "a" { initial = "b", run "walk_to" {}, state "b" { run "walk_to" {} } })", "already runs in state 'a'"},
      {R"(state "a" { { "b", when = done "walk_to" } }, state "b" {})", "awaits 'walk_to', which it does not run"},
      {R"(state "a" { ends = "well" })", "ends: expected \"done\" or \"failed\", found \"well\""},
      {R"(state "a" { ends = "done", { "b", after = 1 } }, state "b" {})", "so it cannot have transitions"},
      {R"(state "a" { ends = "done", run "walk_to" {} })", "so it cannot run another one"},
      {R"(state "a" { ends = "done", initial = "b", state "b" {} })", "so it cannot have inner states"},
  };
  for (const WrongCall& call : wrong) {
    write("walk_to", kWalkTo);
    const ScriptFault fault = refusal("behavior \"refused\" { initial = \"a\",\n" + std::string(call.text) + " }");
    EXPECT_NE(fault.message.find(call.message), std::string::npos) << fault.text() << "\nfor " << call.text;
    EXPECT_EQ(fault.file, "behaviors/refused.lua");
    EXPECT_GE(fault.line, 1) << call.text;
    EXPECT_EQ(fault.message.find('\n'), std::string::npos);
  }
}

TEST_F(ScriptCalls, CirclesOfCallsAreRefused) {
  write("ping", R"(behavior "ping" { initial = "a", state "a" { run "pong" {} } })");
  write("pong", R"(behavior "pong" { initial = "a", state "a" { run "ping" {} } })");
  const ScriptFault fault = refusal(R"(behavior "refused" { initial = "a", state "a" { run "ping" {} } })");
  EXPECT_EQ(fault.text(), "behaviors/pong.lua:1:50: run \"ping\": it runs itself: refused/ping/pong/ping");
}

TEST_F(ScriptCalls, ManyCallsAreRefused) {
  // Each behavior runs two others: 2^7 of them.
  const auto write_one = [&](const std::string& name, const std::string& next) {
    write(name, "behavior \"" + name + "\" { initial = \"a\", state \"a\" { run \"l" + next + "\" {}, run \"r" + next +
                    "\" {} } }");
  };
  for (int level = 0; level < 7; ++level) {
    const std::string number = std::to_string(level);
    for (const char* const side : {"l", "r"}) write_one(side + number, std::to_string(level + 1));
  }
  for (const std::string side : {"l", "r"})
    write(side + "7", "behavior \"" + side + "7\" { initial = \"a\", state \"a\" {} }");
  const ScriptFault fault = refusal(R"(behavior "refused" { initial = "a", state "a" { run "l0" {} } })");
  EXPECT_NE(fault.message.find("too many behaviors"), std::string::npos) << fault.text();
}

TEST_F(ScriptCalls, AFileThatIsRunDeclaresOneBehaviorOfItsName) {
  write("two", R"(behavior "two" { initial = "a", state "a" {} } behavior "more" { initial = "a", state "a" {} })");
  EXPECT_NE(refusal(R"(behavior "refused" { initial = "a", state "a" { run "two" {} } })").message.find("found 2"),
            std::string::npos);
  write("named", R"(behavior "other" { initial = "a", state "a" {} })");
  EXPECT_NE(
      refusal(R"(behavior "refused" { initial = "a", state "a" { run "named" {} } })").message.find("found 'other'"),
      std::string::npos);
}

TEST_F(ScriptCalls, WrongDeclarationsOfArgumentsAreRefused) {
  const WrongCall wrong[] = {
      {"local a = args { x = { 1.0, doc = \"x\" } }", "args x: missing range"},
      {"local a = args { x = { 1.0, range = { 0, 2 }, doc = \"x\" } } local b = args { }", "args is declared twice"},
      {"local a = args { 1 }", "expected named args: args { name = { ... } }"},
      {"local a = args { x = { 3.0, range = { 0, 2 }, doc = \"x\" } }", "x"},
      {"local p = param { x = { 1.0, range = { 0, 2 }, doc = \"x\" } } local a = args { x = { true, doc = \"x\" } }",
       "the script has a param and an argument of this name"},
      {"local a = args { x = { true, doc = \"x\" } } local b = a.y", "args has no field 'y'"},
  };
  for (const WrongCall& call : wrong) {
    const ScriptFault fault =
        refusal(std::string(call.text) + "\nbehavior \"refused\" { initial = \"a\", state \"a\" {} }");
    EXPECT_NE(fault.message.find(call.message), std::string::npos) << fault.text() << "\nfor " << call.text;
  }
}

TEST_F(ScriptCalls, CalledNamesOnlyWhatTheBehaviorRuns) {
  load("player",
       R"(behavior "player" { initial = "a", state "a" { update = function() log.info(called.other.state) end } })");
  tick();
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].fault.message.find("called: 'player' does not run 'other'"), std::string::npos);
}

}  // namespace
}  // namespace reorient

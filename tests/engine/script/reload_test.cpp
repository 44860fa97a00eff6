// SPDX-License-Identifier: MIT
// Reloads: the data that survive, and reloads with invalid scripts.
#include "tests/engine/script/script_fixture.h"

namespace reorient {
namespace {

class ScriptReload : public ScriptTest {};

const std::string kTwoStates = R"(local p = param { wait = { 1.0, range = { 0, 5 }, doc = "x" } }
local memory = keep { visits = 0, deep = { list = { 1, 2 } } }
behavior "b" { initial = "one",
  state "one" { enter = function() memory.visits = memory.visits + 1 memory.deep.list[3] = "three" end, { "two", after = "wait" } },
  state "two" { enter = command.pause_training, update = function() log.info(memory.visits .. memory.deep.list[3]) end } }
)";

std::string edited(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST_F(ScriptReload, StateTimersMemoryAndLeasesSurvive) {
  load("b", kTwoStates);
  ticks(25);
  ReloadRecord report = edit("b", kTwoStates + "-- edited\n");
  EXPECT_TRUE(report.accepted) << report.fault.text();
  EXPECT_TRUE(report.warnings.empty());
  ticks(5);
  EXPECT_EQ(state("b"), "one") << "the time in the state continues";
  ticks(1);
  EXPECT_EQ(state("b"), "two");
  edit("b", kTwoStates + "-- edited again\n");
  const SeenTick& output = tick();
  EXPECT_EQ(output.leases.size(), 1u);
  EXPECT_EQ(logs.back(), "1three");
  EXPECT_EQ(transitions.size(), 2u) << "a reload is no transition";
}

TEST_F(ScriptReload, CanBeRequestedWithoutAChange) {
  const std::string text = R"(behavior "b" { initial = "one",
    state "one" { update = function() if robot.penalized then error("stopped") end log.info("runs") end } })";
  load("b", text);
  load("other", R"(behavior "other" { initial = "one", state "one" {} })");
  world.referee.penalized = true;
  ticks(limits.max_errors);
  EXPECT_TRUE(status("b").stopped);
  world.referee.penalized = false;
  const ScriptText same{text, ""};
  const std::vector<ScriptEdit> saved{{"behaviors/b.lua", same}}, asked{{"behaviors/b.lua", same, true}};
  EXPECT_TRUE(host().apply(saved).empty());
  const std::vector<ReloadRecord> reports = host().apply(asked);
  ASSERT_EQ(reports.size(), 1u) << "the other script must not be reloaded";
  EXPECT_EQ(reports[0].script, "behaviors/b.lua");
  EXPECT_TRUE(reports[0].accepted);
  tick();
  EXPECT_FALSE(status("b").stopped);
  EXPECT_EQ(logs.back(), "runs");
}

TEST_F(ScriptReload, DwellContinues) {
  const std::string text = R"(behavior "b" { initial = "one",
    state "one" { { "two", when = function() return true end, lasting = 1 } }, state "two" {} })";
  load("b", text);
  ticks(25);
  edit("b", text + " ");
  ticks(7);
  EXPECT_EQ(state("b"), "two");
}

TEST_F(ScriptReload, DwellOfAnEarlierVisitDoesNotCount) {
  const std::string text = R"(behavior "b" { initial = "outer",
    state "outer" { initial = "a",
      state "a" { { "c", when = function() return true end, lasting = 3 }, { "b", after = 1 } },
      state "b" {}, state "c" {} } })";
  load("b", text);
  ticks(6 * 30);
  EXPECT_EQ(state("b"), "outer/b");
  edit("b", edited(edited(text, "{ \"b\", after = 1 }", "{ \"b2\", after = 9 }"), "state \"b\"", "state \"b2\""));
  ticks(3 * 30);
  EXPECT_EQ(state("b"), "outer/a");
  ticks(3);
  EXPECT_EQ(state("b"), "outer/c");
}

TEST_F(ScriptReload, ARemovedStateIsReplacedByItsNearestAncestor) {
  load(
      "b",
      R"(behavior "b" { initial = "outer", state "outer" { initial = "x", state "x" { { "y", after = 0.1 } }, state "y" {} }, state "z" {} })");
  ticks(10);
  EXPECT_EQ(state("b"), "outer/y");
  const ReloadRecord report = edit("b", R"(behavior "b" { initial = "z", state "outer" { initial = "x",
    state "x" { enter = function() log.info("+x") end } }, state "z" {} })");
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_EQ(report.warnings[0], "b: state 'outer/y' was removed; it continues in 'outer/x'");
  tick();
  EXPECT_EQ(state("b"), "outer/x");
  EXPECT_EQ(logs, std::vector<std::string>{"+x"});
  EXPECT_EQ(transitions.back().from, "outer/y");
  EXPECT_EQ(transitions.back().to, "outer/x");
}

TEST_F(ScriptReload, AnInvalidEditIsReportedWithItsPositionAndThePreviousVersionStays) {
  load("b", kTwoStates);
  ticks(5);
  for (const char* broken : {"behavior \"b\" { initial = ", "error(\"at load\")", "local t = nil\nlocal x = t.y", "",
                             "behavior \"other\" { state \"a\" { { \"q\", after = 1 } } }"}) {
    const ReloadRecord report = edit("b", broken);
    EXPECT_FALSE(report.accepted);
    EXPECT_EQ(report.script, "behaviors/b.lua");
    EXPECT_EQ(report.fault.file, "behaviors/b.lua");
    EXPECT_GE(report.fault.line, 1);
    EXPECT_FALSE(report.fault.message.empty());
  }
  ticks(30);
  EXPECT_EQ(state("b"), "two");
  EXPECT_TRUE(faults.empty());
  EXPECT_TRUE(edit("b", kTwoStates).accepted);
}

TEST_F(ScriptReload, AFaultAtLoadHasATraceback) {
  load("b", kTwoStates);
  const ReloadRecord report = edit("b", "local function f() error(\"deep\") end\nlocal function g() f() end\ng()");
  EXPECT_EQ(report.fault.line, 1);
  EXPECT_NE(report.fault.traceback.find("behaviors/b.lua:2"), std::string::npos) << report.fault.traceback;
}

TEST_F(ScriptReload, AnUnchangedFileIsNotReloaded) {
  load("b", kTwoStates);
  folder.write("behaviors/b.lua", kTwoStates);
  EXPECT_TRUE(reload().empty());
  folder.write("behaviors/b.lua", "broken(");
  EXPECT_EQ(reload().size(), 1u);
  EXPECT_TRUE(reload().empty()) << "one report for one edit";
}

TEST_F(ScriptReload, AnEditOfALibraryReloadsAllScriptsThatRequireIt) {
  folder.write("lib/words.lua", "return { text = \"old\" }");
  for (const char* name : {"a", "b"}) {
    load(name, "local words = require \"lib.words\" behavior \"" + std::string(name) +
                   "\" { update = function() log.info(words.text) end }");
  }
  load("c", "behavior \"c\" {}");
  folder.write("lib/words.lua", "return { text = \"new\" }");
  EXPECT_EQ(reload().size(), 2u);
  tick();
  EXPECT_EQ(logs, (std::vector<std::string>{"new", "new"}));
}

TEST_F(ScriptReload, AFileThatAppearsLaterIsLoaded) {
  load("b", kTwoStates);
  EXPECT_FALSE(edit("b", "require \"lib.later\"\n" + kTwoStates).accepted);
  folder.write("lib/later.lua", "return 1");
  const auto reports = reload();
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_TRUE(reports[0].accepted) << reports[0].fault.text();
}

TEST_F(ScriptReload, ARemovedFileLeavesThePreviousVersionRunning) {
  load("b", kTwoStates);
  folder.remove("behaviors/b.lua");
  const auto reports = reload();
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_FALSE(reports[0].accepted);
  ticks(40);
  EXPECT_EQ(state("b"), "two");
}

TEST_F(ScriptReload, AVersionThatFailsRepeatedlyIsRolledBack) {
  load("b", kTwoStates);
  ticks(5);
  EXPECT_TRUE(
      edit("b", edited(kTwoStates, "state \"one\" {", "state \"one\" { update = function() error(\"new\") end,"))
          .accepted);
  ticks(limits.max_errors);
  ASSERT_EQ(static_cast<int>(faults.size()), limits.max_errors);
  EXPECT_EQ(faults.back().consequence, FaultRecord::Consequence::rolled_back);
  ticks(60);
  EXPECT_EQ(static_cast<int>(faults.size()), limits.max_errors);
  EXPECT_FALSE(status("b").stopped);
  EXPECT_EQ(state("b"), "two");
  EXPECT_EQ(logs.back(), "1three");
}

TEST_F(ScriptReload, AValueThatARollbackCannotRestoreIsLogged) {
  const std::string good = R"(local memory = keep { n = 1 } behavior "b" { update = function() memory.n = 2 end })";
  load("b", good);
  ticks(5);
  ASSERT_TRUE(edit("b", edited(good, "memory.n = 2", "memory.f = function() end error(\"bad\")")).accepted);
  ticks(limits.max_errors);
  ASSERT_EQ(faults.back().consequence, FaultRecord::Consequence::rolled_back);
  ASSERT_FALSE(logs.empty());
  EXPECT_EQ(logs.back(), "the previous version took over: keep: 'f' cannot survive a reload");
}

TEST_F(ScriptReload, ErrorsOfAVersionInItsLastFrameDoNotCountAgainstTheNextVersion) {
  limits.max_errors = 1;
  const std::string good = R"(behavior "b" { initial = "one",
    state "one" { { "two", after = 1 } }, state "two" { update = function() log.info("runs") end } })";
  load("b", good);
  ticks(5);
  const std::string bad = R"(behavior "b" { initial = "one",
    state "one" { exit = function() error("first") end, { "two", after = 0.5 } },
    state "two" { enter = function() error("second") end } })";
  ASSERT_TRUE(edit("b", bad).accepted);
  ticks(20);
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].consequence, FaultRecord::Consequence::rolled_back);
  EXPECT_EQ(faults[1].consequence, FaultRecord::Consequence::none);
  EXPECT_FALSE(status("b").stopped);
  ASSERT_FALSE(logs.empty());
  EXPECT_EQ(logs.back(), "runs");
}

TEST_F(ScriptReload, OtherScriptsReadARolledBackMachineAsAtTheStartOfTheFrame) {
  const std::string good = R"(behavior "aa" { initial = "one", state "one" {} })";
  load("aa", good);
  load("bb", R"(behavior "bb" { update = function()
    log.info(string.format("%s %.1f", behaviors.aa.state, behaviors.aa.time_in_state))
  end })");
  ticks(31);
  ASSERT_TRUE(
      edit("aa", edited(good, "state \"one\" {", "state \"one\" { update = function() error(\"bad\") end,")).accepted);
  ticks(limits.max_errors);
  ASSERT_EQ(faults.back().consequence, FaultRecord::Consequence::rolled_back);
  EXPECT_EQ(logs.back(), "one 1.2");
}

TEST_F(ScriptReload, AStoppedScriptRestartsWithAValidEdit) {
  load("b", "behavior \"b\" { update = function() error(\"x\") end }");
  ticks(limits.max_errors);
  EXPECT_TRUE(status("b").stopped);
  EXPECT_TRUE(edit("b", kTwoStates).accepted);
  ticks(40);
  EXPECT_EQ(state("b"), "two");
}

TEST_F(ScriptReload, AStoppedScriptThatIsFixedResumesItsLeases) {
  const std::string text = R"(behavior "b" { initial = "watching", state "watching" {
    enter = command.pause_training, update = function() error("x") end } })";
  load("b", text);
  ticks(limits.max_errors);
  EXPECT_TRUE(tick().leases.empty()) << "it is stopped";
  EXPECT_TRUE(edit("b", edited(text, "error(\"x\")", "")).accepted);
  ASSERT_EQ(tick().leases.size(), 1u);
  EXPECT_EQ(state("b"), "watching");
}

TEST_F(ScriptReload, AnOverrideSurvivesAndIsClampedToTheNewRange) {
  load("b", kTwoStates);
  parameters.set("b.wait", "4", ParameterOrigin::live);
  EXPECT_TRUE(edit("b", kTwoStates + " ").warnings.empty());
  EXPECT_EQ(std::get<double>(parameters.value("b.wait")), 4.0);
  const ReloadRecord report = edit("b", edited(kTwoStates, "range = { 0, 5 }", "range = { 0, 2 }"));
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_NE(report.warnings[0].find("b.wait"), std::string::npos);
  EXPECT_EQ(std::get<double>(parameters.value("b.wait")), 2.0);
}

TEST_F(ScriptReload, ARemovedParameterIsNotListed) {
  load("b", kTwoStates);
  EXPECT_NE(parameters.find("b.wait"), nullptr);
  edit("b", "behavior \"b\" {}");
  EXPECT_EQ(parameters.find("b.wait"), nullptr);
}

TEST_F(ScriptReload, AValueThatCannotBeStoredIsNamed) {
  const std::string text =
      "local memory = keep {} behavior \"b\" { enter = function() memory.f = print memory.n = 1 end }";
  load("b", text);
  tick();
  const ReloadRecord report = edit("b", text + " ");
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_EQ(report.warnings[0], "keep: 'f' cannot survive a reload");
}

TEST_F(ScriptReload, AKeptValueOfAnotherTypeIsReplacedByTheNewDefault) {
  load("b",
       "local memory = keep { x = 1, y = 1 } behavior \"b\" { update = function() memory.x = 5 memory.y = 5 end }");
  tick();
  edit("b",
       "local memory = keep { x = \"text\", y = 2 } behavior \"b\" { update = function() log.info(memory.x .. "
       "memory.y) end }");
  tick();
  EXPECT_EQ(logs, std::vector<std::string>{"text5"});
}

TEST_F(ScriptReload, AKeyThatTheScriptRemovedStaysRemoved) {
  const std::string text =
      R"(local memory = keep { todo = { "left", "right", "back" }, target = "ball", deep = { x = 1, y = 2 } }
    behavior "b" { initial = "one", state "one" {
      enter = function()
        table.remove(memory.todo, 1)
        table.remove(memory.todo, 1)
        memory.target = nil
        memory.deep.x = nil
      end,
      update = function()
        print(table.concat(memory.todo, ","), memory.target, memory.deep.x, memory.deep.y)
      end } })";
  load("b", text);
  tick();
  edit("b", text + " ");
  tick();
  EXPECT_EQ(logs, (std::vector<std::string>{"back nil nil 2", "back nil nil 2"}));
}

TEST_F(ScriptReload, KeysThatAreNewInMemoryStartAsDeclared) {
  load("b", R"(local memory = keep { todo = { "left", "right" }, deep = { x = 1 } }
    behavior "b" { enter = function() table.remove(memory.todo) memory.deep.x = 5 memory.seen = {} end })");
  tick();
  edit("b", R"(local memory = keep { todo = { "one", "two", "three" }, deep = { x = 1, y = 2 }, seen = { 7 }, new = 3 }
    behavior "b" { update = function()
      print(table.concat(memory.todo, ","), memory.deep.x, memory.deep.y, memory.seen[1], memory.new)
    end })");
  tick();
  EXPECT_EQ(logs, std::vector<std::string>{"left 5 2 7 3"});
}

TEST_F(ScriptReload, AKeptListIsRestoredAsAWholeUnlessItsTypeChanged) {
  load("b",
       R"(local memory = keep { mixed = { "a", 2, true }, texts = { "a", "b" }, rows = { { n = 1 }, { n = 2, m = 3 } } }
    behavior "b" { enter = function()
      table.remove(memory.mixed, 1) table.remove(memory.texts) table.remove(memory.rows)
    end })");
  tick();
  edit("b",
       R"(local memory = keep { mixed = { "a", 2, true }, texts = { 8, 9 }, rows = { { n = 7, new = 4 }, { n = 2 } } }
    local row = memory.rows[1]
    behavior "b" { update = function()
      print(memory.mixed[1], memory.mixed[2], memory.mixed[3], table.concat(memory.texts, ","), #memory.rows, row.n,
               row.new)
    end })");
  tick();
  EXPECT_EQ(logs, std::vector<std::string>{"2 true nil 8,9 1 1 4"});
}

TEST_F(ScriptReload, AKeyThatARolledBackVersionRemovedStaysRemoved) {
  const std::string good = R"(local memory = keep { a = 1 }
    behavior "b" { initial = "one", state "one" {
      enter = function() memory.made = 2 end, update = function() print(memory.a, memory.made, memory.b) end } })";
  const std::string bad = R"(local memory = keep { a = 1, b = 3 }
    behavior "b" { initial = "one", state "one" {
      update = function() memory.a = nil memory.made = nil error("bad") end } })";
  load("b", good);
  tick();
  ASSERT_TRUE(edit("b", bad).accepted);
  ticks(limits.max_errors + 1);
  EXPECT_EQ(faults.back().consequence, FaultRecord::Consequence::rolled_back);
  EXPECT_EQ(logs.back(), "nil nil 3");
}

TEST_F(ScriptReload, ARestoredHostRemembersRemovedKeys) {
  load("b", R"(local memory = keep { todo = { "left", "right" }, target = "ball", deep = { x = 1 }, changes = 1 }
    local deep = memory.deep
    behavior "b" { initial = "one", state "one" {
      enter = function() table.remove(memory.todo, 1) memory.target = nil deep.x = 4 memory.changes = "text" end,
      update = function() print(table.concat(memory.todo, ","), memory.target, deep.x, memory.changes) end } })");
  tick();
  std::vector<std::byte> bytes;
  ByteWriter out(bytes);
  host().save(out);
  ParameterRegistry fresh;
  Behaviors second(ScriptTexts(), fresh);
  ByteReader in(bytes);
  second.host().restore(in);
  second.tick(world);
  EXPECT_EQ(logs, std::vector<std::string>{"right nil 4 text"});
  ASSERT_EQ(second.said().logs.size(), 1u);
  EXPECT_EQ(second.said().logs[0].text, logs[0]);
}

TEST_F(ScriptReload, TwoScriptsCannotDeclareTheSameMachine) {
  load("b", kTwoStates);
  load("c", "behavior \"c\" {}");
  const ReloadRecord report = edit("c", "behavior \"b\" {}");
  EXPECT_FALSE(report.accepted);
  EXPECT_NE(report.fault.message.find("also declared in behaviors/b.lua"), std::string::npos);
}

TEST_F(ScriptReload, MemoryDoesNotGrowOverManyReloads) {
  load("b", kTwoStates);
  std::size_t before = 0;
  for (int i = 0; i < 200; ++i) {
    EXPECT_TRUE(edit("b", kTwoStates + "-- " + std::to_string(i % 10)).accepted);
    tick();
    if (i == 50) before = status("b").memory;
  }
  EXPECT_LT(status("b").memory, before + 20'000);
}

}  // namespace
}  // namespace reorient

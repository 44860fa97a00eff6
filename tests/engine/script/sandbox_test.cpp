// SPDX-License-Identifier: MIT
// Hostile scripts: each is stopped within its budget, and other scripts continue.
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "geometry/pinned_math.h"
#include "tests/engine/script/script_fixture.h"

namespace reorient {
namespace {

std::string updating(const std::string& body) { return "behavior \"evil\" { update = function() " + body + " end }"; }

const char* const kHonest = "behavior \"honest\" { update = function() head.look(0.5, 0.1) end }";

/// A body of `update` that must end in an error or do no harm.
struct Attack {
  const char* name;
  const char* body;
  const char* error;  ///< a part of the message
};

class HostileScript : public ScriptTest, public ::testing::WithParamInterface<Attack> {};

TEST_P(HostileScript, StopsAloneWithinItsBudget) {
  load("evil", updating(GetParam().body));
  load("honest", kHonest);
  for (int frame = 0; frame < 10; ++frame) {
    const SeenTick& output = tick();
    ASSERT_TRUE(output.request.head.has_value()) << "the valid behavior must continue";
    EXPECT_EQ(output.request.head->angles.yaw, 0.5);
  }
  ASSERT_FALSE(faults.empty());
  for (const FaultRecord& record : faults) {
    EXPECT_EQ(record.script, "behaviors/evil.lua");
    EXPECT_NE(record.fault.message.find(GetParam().error), std::string::npos) << record.fault.text();
  }
  EXPECT_EQ(static_cast<int>(faults.size()), limits.max_errors);
  EXPECT_EQ(faults.back().consequence, FaultRecord::Consequence::stopped);
  EXPECT_TRUE(status("evil").stopped);
  EXPECT_FALSE(status("honest").stopped);
  EXPECT_LE(status("evil").memory, static_cast<std::size_t>(limits.max_memory) * 1024);
}

constexpr const char* kBudget = "budget of 50000 instructions used up";
constexpr const char* kMemory = "memory limit exceeded";

INSTANTIATE_TEST_SUITE_P(
    Attacks, HostileScript,
    ::testing::Values(
        Attack{"EndlessLoop", "while true do end", kBudget},
        Attack{"LoopInsidePcall", "while true do pcall(function() while true do end end) end", kBudget},
        Attack{"LoopInsideNestedPcalls", "local function f() pcall(f) while true do end end f()", kBudget},
        Attack{"LoopInsideXpcall", "while true do xpcall(function() while true do end end, function() end) end",
               kBudget},
        Attack{"LoopInErrorHandler", "xpcall(error, function() while true do end end)", kBudget},
        Attack{"LoopInClosingVariable",
               "local x <close> = setmetatable({}, { __close = function() while true do end end }) while true do end",
               ""},
        Attack{"LoopInMetamethod",
               "local t = setmetatable({}, { __index = function() while true do end end }) local _ = t.x", kBudget},
        Attack{"LoopInToString", "tostring(setmetatable({}, { __tostring = function() while true do end end }))",
               kBudget},
        Attack{"LoopInSorting", "table.sort({ 3, 1, 2 }, function() while true do end end)", kBudget},
        Attack{"LoopInReplacement", "(\"a\"):gsub(\"a\", function() while true do end end)", kBudget},
        Attack{"LoopInPairs", "for _ in pairs(setmetatable({}, { __pairs = function() while true do end end })) do end",
               kBudget},
        Attack{"DeepRecursion", "local function f() return 1 + f() end f()", "more than 200 deep"},
        Attack{"DeepRecursionOverPcall", "local function f() return pcall(f) end error(f())", ""},
        Attack{"DeepRecursionOverMetamethods",
               "local t = {} setmetatable(t, { __index = function(_, k) return t[k + 1] end }) local _ = t[1]", ""},
        Attack{"ChainOfCalls", "local f = type for _ = 1, 3000 do f = setmetatable({}, { __call = f }) end f()",
               "too many metatables (expected at most 32)"},
        Attack{"ChainOfIndices", "local t = {} for _ = 1, 1900 do t = setmetatable({}, { __index = t }) end return t.x",
               "too many metatables (expected at most 32)"},
        Attack{"ChainThatIsLinkedLater",
               "local kinds, t = {}, {} for i = 1, 1900 do kinds[i] = {} setmetatable({}, kinds[i]) end",
               "too many metatables (expected at most 32)"},
        Attack{"CircleOfCalls", "local t = {} setmetatable(t, { __call = t }) t()", kMemory},
        Attack{"CircleOfIndices", "local t = {} setmetatable(t, { __index = t }) return t.x", "possible loop"},
        Attack{"StringBomb", "local s = \"x\" while true do s = s .. s end", kMemory},
        Attack{"StringRepetition", "local _ = (\"x\"):rep(1e9)", "expected at most 4096 bytes"},
        Attack{"RepetitionOfNothing", "for _ = 1, 1e9 do (\"\"):rep(1e15) end", kBudget},
        Attack{"RepetitionThatOverflows", "local _ = (\"xy\"):rep(math.maxinteger, \",\")",
               "expected at most 4096 bytes"},
        Attack{"PatternBomb", "(\"a\"):rep(700):find(\".-.-.-b\")", kBudget},
        Attack{"PatternBombInsidePcall", "while true do pcall(string.find, (\"a\"):rep(700), \".-.-.-b\") end",
               kBudget},
        Attack{"PatternBombOverGmatch", "for _ in (\"a\"):rep(4000):gmatch(\".-.-.-.-b\") do end", kBudget},
        Attack{"PatternBombOverGsub",
               "(\"a\"):rep(4000):gsub(\"(a*)*b\", \"\") (\"a\"):rep(4000):gsub(\".-.-.-b\", \"\")", kBudget},
        Attack{"PatternThatNests", "(\"a\"):rep(300):find((\"a?\"):rep(300) .. (\"a\"):rep(300))",
               "pattern too complex"},
        Attack{"ReplacementBomb", "(\"x\"):rep(4000):gsub(\"x\", \"%0%0\")", "expected at most 4096 bytes"},
        Attack{"ReplacementBombOfOneMatch", "(\"x\"):rep(4000):gsub(\"^.*\", (\"%0\"):rep(2000))",
               "expected at most 4096 bytes"},
        Attack{"FormatBomb", "for i = 1, 1e9 do string.format(\"%99.99f\", 1e308) end", kBudget},
        Attack{"GigabyteTable", "local t = {} for i = 1, 1e12 do t[i] = i end", ""},
        Attack{"TablesOfTables", "local t = {} while true do t = { t, {}, {}, {} } end", ""},
        Attack{"MemoryInsidePcall",
               "while true do pcall(function() local t = {} for i = 1, 1e9 do t[i] = {} end end) end", kBudget},
        Attack{"ForgedLength", "table.insert(setmetatable({}, { __len = function() return 1 << 60 end }), 1, 1)",
               "plain table"},
        Attack{
            "FakeBorder",
            "local t = {} for i = 0, 61 do t[1 << i] = 1 end table.insert(t, 1, 1) table.concat(t, \"\", 1, 1 << 61)",
            ""},
        Attack{"MoveOverEverything", "table.move({}, 1, 1 << 60, 2)", kBudget},
        Attack{"MoveOverAllIntegers", "table.move({}, math.mininteger, math.maxinteger - 1, 1)", kBudget},
        Attack{"UnpackTooMuch", "table.unpack({}, 1, 1e8)", kBudget},
        Attack{"ConcatTooMuch",
               "table.concat(setmetatable({}, { __index = function() return \"x\" end }), \"\", 1, 1e15)",
               "plain table"},
        Attack{"WritesTheWorld", "robot.penalized = true", "robot is read-only"},
        Attack{"WritesTheWorldRaw", "rawset(robot, \"fallen\", true)", "read-only"},
        Attack{"ReplacesTheWorldsMetatable", "setmetatable(robot, { __index = {} })", "protected"},
        Attack{"WritesIntoTheWorldsMetatable", "getmetatable(robot).__index = {}", "index a boolean"},
        Attack{"WritesAnothersState", "behaviors.honest.state = \"x\"", "read-only"},
        Attack{"ChangesTheStringMetatable", "getmetatable(\"\").__index = {}", "index a boolean"},
        Attack{"WritesGlobals", "x = 1", "unknown variable 'x'"},
        Attack{"ReplacesGlobalsRaw", "rawset(_ENV, \"robot\", {})", "read-only"},
        Attack{"Finalizer", "setmetatable({}, { __gc = function() while true do end end })", "__gc"},
        Attack{"ErrorOfNil", "error(nil)", "error value of type nil"},
        Attack{"ErrorOfTable", "error({})", "error value of type table"},
        Attack{"ErrorInErrorHandler", "local ok, what = xpcall(error, function() error(\"again\") end) error(what)",
               "again"},
        Attack{"CallsNil", "local f f()", "call a nil value"},
        Attack{"RequiresLater", "require \"lib.walk\"", "require is only allowed at the top"},
        Attack{"DeclaresLater", "behavior \"second\" {}", "while a script is loaded"},
        Attack{"NotANumber", "head.look(0 / 0, 0)", "finite number"},
        Attack{"EndlessSpeed", "walk.velocity(math.huge, 0, 0)", "finite number"},
        Attack{"CommandFlood", "while true do command.flip_pose() end", "too many actions"},
        Attack{"LogFlood", "while true do log.info(\"x\") end", kBudget},
        Attack{"UnknownFieldOfABehavior", "local _ = behaviors.honest.stat", "unknown field 'stat'"},
        Attack{"UnknownField", "local _ = robot.penalised",
               "robot has no field 'penalised' (did you mean 'penalized'?)"},
        Attack{"TheTruth", "local _ = truth.x", "unknown name 'truth'"},
        Attack{"TheOperator", "operator.pick_up()", "unknown name 'operator'"}),
    [](const auto& attack) { return std::string(attack.param.name); });

class Sandboxed : public ScriptTest {};

TEST_F(Sandboxed, ReportsAnEndlessLoopOfALibraryAtItsOwnLine) {
  folder.write("lib/endless.lua", "local library = {}\nwhile true do end\nreturn library");
  folder.write("lib/between.lua", "return require \"lib.endless\"");
  const ScriptFault fault = refusal("\n\n\nrequire \"lib.between\" behavior \"refused\" {}");
  EXPECT_EQ(fault.file, "lib/endless.lua");
  EXPECT_EQ(fault.line, 2);
  EXPECT_NE(fault.message.find("endless loop"), std::string::npos) << fault.message;
}

TEST_F(Sandboxed, AcceptsAByteOrderMarkAtTheBeginningOfAFileOnly) {
  load("windows", "\xEF\xBB\xBF-- saved on Windows\r\nbehavior \"windows\" { state \"a\" { { \"a\", after = 1 } } }");
  EXPECT_EQ(host().definitions().size(), 1u);
  const ScriptFault fault = refusal("\xEF\xBB\xBFlocal a =\n+");
  EXPECT_EQ(fault.line, 2);
  EXPECT_NE(refusal("\n\xEF\xBB\xBF"
                    "behavior \"refused\" {}")
                .message.find("near"),
            std::string::npos);
}

TEST_F(Sandboxed, WritesWhatIsNotANumberWithoutASign) {
  load("numbers", R"(local negative, positive = -(0 / 0), 0 / 0
for _, nan in ipairs { negative, positive } do
  assert(tostring(nan) == "nan" and nan .. "" == "nan" and table.concat { nan } == "nan")
  assert(string.format("%s|%g|%.1f|%6.2f|%-6e|%A|%%", nan, nan, nan, nan, nan, nan) == "nan|nan|nan|   nan|nan   |NAN|%")
end
assert(string.format("%5.1f|%g|%d|%x|%s", -2.25, -math.huge, -3, 255, "-nan") == " -2.2|-inf|-3|ff|-nan")
behavior "numbers" {})");
  EXPECT_EQ(host().definitions().size(), 1u);
}

TEST_F(Sandboxed, NoFunctionLeavesTheSandbox) {
  for (const char* name :
       {"io", "os", "debug", "package", "load", "loadstring", "loadfile", "dofile", "collectgarbage", "coroutine", "_G",
        "utf8", "newproxy", "next", "string.dump", "string.pack", "math.randomseed"}) {
    const std::string text = std::string("local ok, value = pcall(function() return ") + name +
                             " end) if ok and value ~= nil then error(\"escaped\") end behavior \"refused\" {}";
    EXPECT_EQ(refusal(text).message, "the script was accepted") << name;
    folder.write("behaviors/refused.lua", "");
    reload();
  }
}

TEST_F(Sandboxed, BytecodeIsRefused) {
  EXPECT_NE(refusal(std::string("\x1bLuaT\x00\x19\x93\r\n", 10)).message.find("attempt to load a binary chunk"),
            std::string::npos);
}

TEST_F(Sandboxed, AScriptWithManyLogLinesDoesNotBlockOthersAndDroppedLinesAreCounted) {
  load("chatty", updating("for i = 1, 150 do log.info(i) end"));
  load("quiet", R"(behavior "quiet" { update = function() log.info("heard") end })");
  tick();
  const std::vector<LogRecord>& said = behaviors().said().logs;
  ASSERT_EQ(said.size(), ScriptActions::kMostPerFrame + 1);
  EXPECT_EQ(said[ScriptActions::kMostPerFrame - 1].dropped, 150 - static_cast<int>(ScriptActions::kMostPerFrame));
  EXPECT_EQ(said.back().text, "heard");
  EXPECT_EQ(said.back().dropped, 0);
  tick();
  EXPECT_EQ(behaviors().said().logs.size(), ScriptActions::kMostPerFrame + 1) << "counted separately in each frame";
}

TEST_F(Sandboxed, TooManyCommandsAreNoErrorOfTheNextScript) {
  load("evil", updating("for i = 1, 150 do command.flip_pose() end"));
  load("honest", R"(behavior "honest" { update = function() command.flip_pose() end })");
  const SeenTick& output = tick();
  ASSERT_EQ(output.faults.size(), 1u);
  EXPECT_EQ(output.faults[0].script, "behaviors/evil.lua");
  EXPECT_EQ(output.commands.back().machine, "honest");
}

TEST_F(Sandboxed, AnErrorInExitDoesNotKeepTheMachineInTheState) {
  load("evil", R"(behavior "evil" { initial = "a",
    state "a" { exit = function() error("no") end, { "b", after = 0.1 } },
    state "b" { enter = function() log.info("entered b") end } })");
  ticks(10);
  EXPECT_EQ(state("evil"), "b");
  EXPECT_EQ(logs, std::vector<std::string>{"entered b"});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].fault.line, 2);
}

TEST_F(Sandboxed, ALoopInExitEndsTheLease) {
  load("evil", R"(behavior "evil" { initial = "a",
    state "a" { enter = function() command.pause_training() end, exit = function() while true do end end, { "b", after = 0.1 } },
    state "b" {} })");
  EXPECT_EQ(tick().leases.size(), 1u);
  ticks(10);
  EXPECT_EQ(state("evil"), "b");
  EXPECT_TRUE(tick().leases.empty());
}

TEST_F(Sandboxed, TheLeasesOfAStoppedScriptEnd) {
  load("evil",
       R"(behavior "evil" { enter = function() command.pause_training() end, update = function() error("no") end })");
  EXPECT_EQ(tick().leases.size(), 1u);
  ticks(limits.max_errors);
  EXPECT_TRUE(status("evil").stopped);
  EXPECT_TRUE(tick().leases.empty());
}

TEST_F(Sandboxed, ErrorsThatAreFarApartAreNotAddedUp) {
  load(
      "evil",
      R"(behavior "evil" { initial = "a", state "a" { { "b", after = 11 } }, state "b" { enter = function() error("no") end,
    { "a", after = 1 } } })");
  ticks(30 * 12 * 8);
  EXPECT_GE(static_cast<int>(faults.size()), limits.max_errors);
  EXPECT_FALSE(status("evil").stopped);
}

/// A call of a table moves its arguments once for each stack slot below them: a million slots would take minutes.
TEST_F(Sandboxed, ACycleOfCallsEndsEarlyEvenWithMuchMemory) {
  limits.max_memory = 64 * 1024;
  load("evil", updating("local t = {} setmetatable(t, { __call = t }) t()"));
  tick();
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].fault.message.find(kMemory), std::string::npos) << faults[0].fault.text();
}

TEST_F(Sandboxed, MetatablesOfEarlierFramesDoNotAccumulate) {
  load("one", R"(local Point = {} Point.__index = Point
    behavior "one" { update = function()
      local point <const> = setmetatable({ x = 1 }, Point)
      for i = 1, 3 do local closed <close> = setmetatable({}, { __close = function() point.x = i end }) end
    end })");
  ticks(300);
  EXPECT_TRUE(faults.empty()) << faults[0].fault.text();
}

TEST_F(Sandboxed, LoadingHasABudget) {
  EXPECT_NE(refusal("while true do end").message.find("budget of 2000000"), std::string::npos);
  EXPECT_NE(refusal("pcall(function() while true do end end) behavior \"refused\" {}").message.find("budget"),
            std::string::npos);
}

TEST_F(Sandboxed, ALoopInARequiredFileIsNotCaughtByPcall) {
  folder.write("lib/evil.lua", "while true do end");
  EXPECT_NE(refusal("pcall(require, \"lib.evil\") behavior \"refused\" {}").message.find("budget"), std::string::npos);
}

TEST_F(Sandboxed, AnActionWhileAScriptIsLoadedIsRefused) {
  for (const char* call : {"command.flip_pose()", "command.pause_training()", "head.look(0, 0)", "walk.stand()",
                           "motion.get_up()", "log.info(\"x\")", "print(\"x\")", "time_in_state()"}) {
    const ScriptFault fault = refusal(std::string(call) + " behavior \"refused\" {}");
    EXPECT_NE(fault.message.find("while"), std::string::npos) << call << ": " << fault.message;
    EXPECT_EQ(fault.line, 1) << call;
  }
  EXPECT_NE(refusal("local x = robot.penalized").message.find("being loaded"), std::string::npos);
}

TEST_F(Sandboxed, FilesOutsideOfTheRootCannotBeRequired) {
  for (const char* module :
       {"../secret", "..secret", "/etc/passwd", "lib..x", "", "lib.", ".lib", "lib\\0x", "lib.gone"}) {
    const ScriptFault fault = refusal("require \"" + std::string(module) + "\" behavior \"refused\" {}");
    EXPECT_NE(fault.message, "the script was accepted") << module;
  }
}

TEST_F(Sandboxed, ACyclicRequireIsRefused) {
  folder.write("lib/a.lua", "require \"lib.b\"");
  folder.write("lib/b.lua", "require \"lib.a\"");
  EXPECT_NE(refusal("require \"lib.a\" behavior \"refused\" {}").message.find("requires itself"), std::string::npos);
}

TEST_F(Sandboxed, DeclarationsThatContainThemselvesAreRefused) {
  EXPECT_NE(refusal("local t = {} t[1] = state \"x\" (t) behavior \"refused\" (t)").message, "the script was accepted");
}

TEST_F(Sandboxed, MathematicalFunctionsAreTheSameAsInTheEngine) {
  load("b", R"(behavior "b" { update = function()
    for _, value in ipairs { math.sin(1.3), math.cos(7.1), math.tan(0.4), math.asin(0.3), math.acos(0.3), math.atan(2, -3),
                             math.exp(1.7), math.log(5.3), math.log(5.3, 2), math.log(5.3, 10), 2.3 ^ -1.7 } do
      print(string.format("%a", value))
    end
  end })");
  tick();
  std::vector<std::string> expected;
  for (const double value : {pinned::sin(1.3), pinned::cos(7.1), pinned::tan(0.4), pinned::asin(0.3), pinned::acos(0.3),
                             pinned::atan2(2.0, -3.0), pinned::exp(1.7), pinned::log(5.3), pinned::log2(5.3),
                             pinned::log10(5.3), pinned::pow(2.3, -1.7)}) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%a", value);
    expected.emplace_back(text.data());
  }
  EXPECT_EQ(logs, expected);
}

TEST_F(Sandboxed, RandomNumbersAreInTheirRange) {
  load("b", R"(behavior "b" { update = function()
    local seen = {}
    for i = 1, 500 do
      local dice = math.random(6)
      assert(math.type(dice) == "integer" and 1 <= dice and dice <= 6)
      seen[dice] = true
      local share = math.random()
      assert(0 <= share and share < 1)
      assert(-2 <= math.random(-2, 1) and math.random(-2, 1) <= 1)
      assert(math.random(7, 7) == 7)
      math.random(math.mininteger, math.maxinteger)
      math.random(0)
    end
    assert(#seen == 6)
    assert(not pcall(math.random, 0, -1) and not pcall(math.random, 1, 2, 3) and not pcall(math.random, 1.5))
    print("done")
  end })");
  tick();
  EXPECT_TRUE(faults.empty()) << faults[0].fault.text();
  EXPECT_EQ(logs, (std::vector<std::string>{"done"}));
}

TEST_F(Sandboxed, TheSameScriptHasTheSameRandomNumbersAndTheSameOrderOfKeys) {
  const char* const text = R"(behavior "one" { enter = function()
      local t, line = { zebra = 1, ant = 2, [3] = 3, [1] = 1, bee = 4 }, ""
      for k, v in pairs(t) do line = line .. tostring(k) .. "=" .. tostring(v) .. " " end
      print(line, math.random(1000000), {}, print, string.format("%s", {}))
    end })";
  load("one", text);
  tick();
  ParameterRegistry fresh;
  Behaviors second(host().texts(), fresh);
  second.host().load("one");
  second.tick(World{});
  ASSERT_EQ(logs.size(), 1u);
  EXPECT_EQ(second.said().logs.at(0).text, logs[0]);
  EXPECT_TRUE(logs[0].starts_with("1=1 3=3 ant=2 bee=4 zebra=1  ")) << logs[0];
  EXPECT_TRUE(logs[0].ends_with(" table function table")) << logs[0];
}

TEST_F(Sandboxed, TablesWithKeysWithoutAReproducibleOrderAreNotIterated) {
  load("one", updating("local t = { [print] = 1 } for k in pairs(t) do print(k) end"));
  load("two", R"(behavior "two" { update = function()
    local t, line = { [{}] = 1, x = 2 }, ""
    print(pcall(pairs, t))
    local large = 1 << 60
    for k in pairs { [true] = 1, [false] = 1, [large + 1] = 1, [large] = 1, [1.5] = 1, [-1] = 1, x = 1 } do
      line = line .. (math.type(k) == "integer" and k > large - 1 and "large+" .. k - large or tostring(k)) .. " "
    end
    print(line)
  end })");
  tick();
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].fault.message.find("a key of type function"), std::string::npos) << faults[0].fault.text();
  ASSERT_EQ(logs.size(), 2u);
  EXPECT_TRUE(logs[0].starts_with("false ")) << logs[0];
  EXPECT_NE(logs[0].find("a key of type table"), std::string::npos) << logs[0];
  EXPECT_EQ(logs[1], "false true -1 1.5 large+0 large+1 x ");
}

TEST_F(Sandboxed, NextFollowsTheOrderOfPairs) {
  load("one", R"(behavior "one" { update = function()
    local t, line = { zebra = 1, ant = 2, [3] = 3, [1] = 1, [true] = 5, [-1.5] = 4 }, ""
    local key, value = next(t)
    while key ~= nil do
      line = line .. tostring(key) .. "=" .. value .. " "
      key, value = next(t, key)
    end
    print(line, next({}) == nil, next({ nil, 2 }), next(t, "zebra"), next(t, 2))
    for k, v in next, { b = 1, a = 2 } do print(k, v) end
    print(pcall(next, setmetatable({}, { __pairs = function() end })))
    print(pcall(next, { [{}] = 1 }))
    print(pcall(next, { 1 }, {}))
    print(pcall(next))
  end })");
  tick();
  ASSERT_EQ(faults.size(), 0u) << faults[0].fault.text();
  ASSERT_EQ(logs.size(), 7u);
  EXPECT_EQ(logs[0], "true=5 -1.5=4 1=1 3=3 ant=2 zebra=1  true 2 nil 3 3");
  EXPECT_EQ(logs[1] + "; " + logs[2], "a 2; b 1");
  EXPECT_NE(logs[3].find("next: this table has __pairs (expected a plain table; write pairs)"), std::string::npos);
  EXPECT_NE(logs[4].find("next: a key of type table has no reproducible order"), std::string::npos) << logs[4];
  EXPECT_NE(logs[5].find("next: a key of type table has no reproducible order"), std::string::npos) << logs[5];
  EXPECT_NE(logs[6].find("table expected, got no value"), std::string::npos) << logs[6];
}

TEST_F(Sandboxed, ATextInArithmeticSaysWhatToWrite) {
  load("one", R"(behavior "one" { update = function()
    local sum = setmetatable({}, { __add = function(a, b) return "added " .. (type(a) == "table" and b or a) end })
    print("x" + sum, sum + "x", -tonumber("2"), tonumber("10") + 1, "2" .. 3)
    for _, wrong in ipairs {
      function() return "10" + 1 end, function() return 1 - "x" end, function() return "2" * "3" end,
      function() return -"4" end, function() return "5" // {} end, function() return "6" % 2 end,
      function() return 2 ^ "7" end, function() return "8" / 2 end } do print(pcall(wrong)) end
  end })");
  tick();
  ASSERT_EQ(faults.size(), 0u) << faults[0].fault.text();
  ASSERT_EQ(logs.size(), 9u);
  EXPECT_EQ(logs[0], "added x added x -2 11 23");
  const char* const found[] = {"10", "x", "2", "4", "5", "6", "7", "8"};
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NE(logs[i + 1].find("attempt to perform arithmetic on the string value '" + std::string(found[i]) +
                               "' (expected a number; write tonumber(...))"),
              std::string::npos)
        << logs[i + 1];
  }
}

TEST_F(Sandboxed, TheMemoryOfAScriptThatMakesGarbageStaysBounded) {
  load("one", updating("local t = {} for i = 1, 100 do t[i] = { i, tostring(i) } end"));
  ticks(2000);
  EXPECT_TRUE(faults.empty());
  EXPECT_LT(status("evil").memory, 1024u * 1024u);
}

TEST_F(Sandboxed, AFaultIsOneLineWithItsFileForAnyMessageOfTheScript) {
  load("loud", "behavior \"loud\" { update = function() error(\"first\\nsecond\") end }");
  load("greedy", R"(behavior "greedy" { update = function() local t = {} for i = 1, 1e9 do t[i] = { i } end end })");
  tick();
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].fault.text(), "behaviors/loud.lua:1: first second");
  EXPECT_TRUE(faults[1].fault.text().starts_with("behaviors/greedy.lua")) << faults[1].fault.text();
}

}  // namespace
}  // namespace reorient

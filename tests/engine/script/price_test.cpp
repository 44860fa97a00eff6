// SPDX-License-Identifier: MIT
// All work has a cost in instructions, even if no instruction is executed. A budget of instructions limits the time
// only if it includes the most expensive work.
#include <sys/resource.h>

#include "tests/engine/script/script_fixture.h"

namespace reorient {
namespace {

/// The largest memory that this program has used so far, in KiB.
long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

class Prices : public ScriptTest {
 protected:
  /// Number of rounds of an endless loop with this body until the budget is used up.
  lua_Integer rounds(const std::string& before, const std::string& body) {
    Sandbox sandbox{limits};
    lua_State* const L = sandbox.state();
    sandbox.grant(limits.instructions_per_load);
    const std::string text =
        before + " local n = 0 return function() while true do n = n + 1 " + body + " end end, function() return n end";
    EXPECT_FALSE(sandbox.compile(text, "prices"));
    EXPECT_FALSE(sandbox.call(0, 2));
    sandbox.grant(limits.instructions_per_frame);
    lua_pushvalue(L, -2);
    const std::optional<ScriptFault> fault = sandbox.call(0, 0);
    EXPECT_TRUE(fault && fault->message.find("budget") != std::string::npos) << (fault ? fault->text() : "it ended");
    sandbox.grant(limits.instructions_per_frame);
    EXPECT_FALSE(sandbox.call(0, 1));
    return lua_tointeger(L, -1);
  }
};

TEST_F(Prices, AnErrorCostsMoreThanAnInstruction) {
  EXPECT_LT(rounds("", "pcall(error)"), 30);
  EXPECT_LT(rounds("", "xpcall(error, function() end)"), 30);
  EXPECT_LT(rounds("local t", "pcall(function() return t.x end)"), 30);
  EXPECT_LT(rounds("local t = setmetatable({}, { __close = error })", "pcall(function() local x <close> = t end)"), 30);
}

TEST_F(Prices, ACallWithoutAnErrorHasNoExtraCost) { EXPECT_GT(rounds("", "pcall(type, 1)"), 4000); }

TEST_F(Prices, TheCostOfReadingANumberGrowsWithTheLengthOfTheText) {
  EXPECT_LT(rounds("local text = (' '):rep(4000)", "tonumber(text)"), 15);
  EXPECT_LT(rounds("local text = ('1'):rep(4000)", "tonumber(text, 36)"), 15);
}

TEST_F(Prices, InstructionsThatReadALongTextCostMore) {
  EXPECT_LT(rounds("local text = (' '):rep(4000) .. '1'", "for i = 1, text do break end"), 500);
  EXPECT_LT(rounds("local text = (' '):rep(4000) .. '1'", "local x = math.floor(text)"), 500);
  EXPECT_GT(rounds("local text = (' '):rep(40) .. '1'", "for i = 1, text do break end"), 3000);
}

TEST_F(Prices, TheCostOfAReplacementGrowsWithItsPartsEvenIfTheyAreEmpty) {
  EXPECT_LT(rounds("local parts = ('%1'):rep(2000)", "local _ = ('x'):gsub('x(y*)', parts)"), 30);
  EXPECT_LT(rounds("local parts = ('%%'):rep(2000)", "local _ = ('x'):gsub('x', parts)"), 30);
  EXPECT_GT(rounds("", "local _ = ('x'):gsub('x', '%0')"), 2000);
}

TEST_F(Prices, AReplacementThatIsTooLongIsRefusedBeforeItIsMade) {
  limits.string_length = 64 * 1024;
  limits.instructions_per_frame = 1'000'000;
  const long before = peak_memory();
  rounds("local text, all = ('x'):rep(16000), ('%0'):rep(16000)", "pcall(string.gsub, text, '^.*', all)");
  EXPECT_LT(peak_memory() - before, 64 * 1024) << "the whole text would have 250 MiB";
}

TEST_F(Prices, EachCycleOfCallsCostsAWholeBudget) {
  EXPECT_LT(rounds("local t = {} setmetatable(t, { __call = t })", "pcall(t)"), 3);
}

TEST_F(Prices, InstructionsCostMoreWithLongerChainsOfMetatables) {
  const std::string chain = "local t = {} for i = 1, COUNT do t = setmetatable({}, { __index = t }) end";
  const auto of = [&](const char* count) { return std::string(chain).replace(chain.find("COUNT"), 5, count); };
  EXPECT_LT(rounds(of("32"), "local _ = t.x"), 3000);
  EXPECT_EQ(rounds(of("7"), "local _ = t.x"), rounds(of("0"), "local _ = t.x"))
      << "a few metatables have no extra cost";
}

TEST_F(Prices, TheCostOfResizingATableGrowsWithItsSize) {
  const std::string large = "local t, k = {}, 1 << 40 for i = 1, 16384 do t[i] = i end t[k] = 1";
  EXPECT_LT(rounds(large, "k = k + 2 t[k] = 1 t[k] = nil"), 100);
  EXPECT_GT(rounds("", "local t = {} t.a = 1 t.b = 2 t.c = 3"), 1000);
}

TEST_F(Prices, TheCostOfIteratingATableGrowsWithItsSlotsEvenIfTheyAreEmpty) {
  const std::string emptied = "local t = {} for i = 1, 16384 do t[i] = i end for i = 1, 16384 do t[i] = nil end";
  EXPECT_LT(rounds(emptied, "pairs(t)"), 100);
  EXPECT_GT(rounds("local t = { x = 1, y = 2 }", "pairs(t)"), 1500);
}

TEST_F(Prices, SortingLongTextsCostsMore) {
  const std::string same = "local text, t = ('x'):rep(COUNT), {} for i = 1, 100 do t[i] = text end";
  const auto of = [&](const char* count) { return std::string(same).replace(same.find("COUNT"), 5, count); };
  EXPECT_LT(rounds(of("4000"), "table.sort(t)"), 4);
  EXPECT_GT(rounds(of("40"), "table.sort(t)"), 60);
}

TEST_F(Prices, ACallOfTheEngineCostsMoreThanAnInstruction) {
  load("looker", R"(local memory = keep { looks = 0 }
    behavior "looker" { update = function()
      if memory.looks > 0 then log.info(memory.looks) memory.looks = 0 return end
      while true do memory.looks = memory.looks + 1 head.look(0, 0) end
    end })");
  ticks(2);
  ASSERT_EQ(logs.size(), 1u);
  EXPECT_LT(std::stoi(logs[0]), 3500);
}

TEST_F(Prices, WritingANumberHasACost) { EXPECT_LT(rounds("", "tostring(1.5)"), 1000); }

TEST_F(Prices, ReadingAnotherMachineHasACost) {
  load("one", R"(local memory = keep { asked = 0 }
    behavior "one" { update = function()
      if memory.asked > 0 then log.info(memory.asked) memory.asked = 0 return end
      while true do memory.asked = memory.asked + 1 local _ = behaviors.one.state end
    end })");
  ticks(2);
  ASSERT_EQ(logs.size(), 1u);
  EXPECT_LT(std::stoi(logs[0]), 1200);
}

TEST_F(Prices, NoInstructionCopiesThousandsOfValues) {
  for (const char* many : {"('x'):rep(4000):byte(1, -1)", "table.unpack({}, 1, 4000)"}) {
    load(std::string("b") + std::to_string(faults.size()),
         "behavior \"b" + std::to_string(faults.size()) + "\" { enter = function() select('#', " + many + ") end }");
    tick();
    EXPECT_NE(faults.back().fault.message.find("too many results (expected at most 250)"), std::string::npos) << many;
  }
  load("deep",
       R"(local function f(...) if select("#", ...) > 2000 then log.info("came through") end return f(1, ...) end
    behavior "deep" { enter = function() f() end })");
  tick();
  EXPECT_NE(faults.back().fault.message.find("too many arguments (expected at most 250)"), std::string::npos);
  EXPECT_TRUE(logs.empty());
}

TEST_F(Prices, VariablesWhoseCloseOpensOthersEnd) {
  load("evil", R"(local kind = {}
    local one = setmetatable({}, kind)
    local function open()
      local a <close> = one
      local b <close> = one
      error("again")
    end
    kind.__close = open
    behavior "evil" { update = open })");
  ticks(limits.max_errors);
  ASSERT_FALSE(faults.empty());
  EXPECT_TRUE(status("evil").stopped);
}

TEST_F(Prices, ForLoopsWhoseCloseOpensOthersEnd) {
  load("evil", R"(local kind = {}
    local one = setmetatable({}, kind)
    local function open()
      for _ in function() return 1 end, nil, nil, one do
        for _ in function() return 1 end, nil, nil, one do error("again") end
      end
    end
    kind.__close = open
    behavior "evil" { update = function() while true do pcall(open) end end })");
  ticks(limits.max_errors);
  ASSERT_FALSE(faults.empty());
  EXPECT_TRUE(status("evil").stopped);
}

TEST_F(Prices, KeptTextsCountAtEachPosition) {
  limits.instructions_per_frame = 10'000'000;
  const std::string text = R"(local memory = keep {}
    behavior "b" { enter = function() local long = ("x"):rep(4000) for i = 1, 5000 do memory[i] = long end end })";
  load("b", text);
  tick();
  ASSERT_TRUE(faults.empty()) << faults[0].fault.text();
  const ReloadRecord report = edit("b", text + " ");
  EXPECT_TRUE(report.accepted);
  EXPECT_FALSE(report.warnings.empty());
  EXPECT_LE(report.warnings.size(), 20u);
  tick();
  EXPECT_LE(status("b").memory, static_cast<std::size_t>(limits.max_memory) * 1024);
}

TEST_F(Prices, ATableIsNotStoredThousandsOfTimes) {
  const ScriptFault fault = refusal("local t = {} for i = 1, 3000 do keep(t) end behavior \"refused\" {}");
  EXPECT_NE(fault.message.find("too many keep { } (expected at most 100)"), std::string::npos) << fault.text();
}

TEST_F(Prices, TheNumberOfTransitionsIsLimited) {
  const ScriptFault fault = refusal(R"(local many = {}
    local one = { "a", after = 1 }
    for i = 1, 20000 do many[i] = one end
    local a = state "a" (many)
    local list = {}
    for i = 1, 900 do list[i] = a end
    behavior "refused" (list))");
  EXPECT_NE(fault.message.find("too many transitions"), std::string::npos) << fault.text();
}

TEST_F(Prices, TheEndOfTheBudgetIsReportedWithItsPosition) {
  load("evil", "behavior \"evil\" {\n  update = function()\n    while true do end\n  end }");
  tick();
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].fault.file, "behaviors/evil.lua");
  EXPECT_EQ(faults[0].fault.line, 3);
}

}  // namespace
}  // namespace reorient

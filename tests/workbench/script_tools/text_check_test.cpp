// SPDX-License-Identifier: MIT
// What the check finds in the text of a script, and at which position. Correct scripts must give no finding.
#include "workbench/script_tools/check/text_check.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

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
  DeclaredNames declared;
  declared.behaviors["other"] = {"", "waiting", "going", "going/slowly"};
  declared.published = {"pose_is_searched"};
  SymbolTable names = symbol_table(ScriptRole::behavior, declared);
  const auto module = std::make_shared<TableSymbol>(TableSymbol{"lib.walk", "lib.walk has no field '", {}, false});
  module->fields = {{"walk_to", {}}, {"turn", {}}};
  names.modules["lib.walk"] = {kTable, module};
  return names;
}

class TextSlips : public ::testing::TestWithParam<Slip> {};

TEST_P(TextSlips, AreFoundAtTheirPosition) {
  const std::vector<Finding> found = check_text(GetParam().text, known()).findings;
  ASSERT_EQ(found.size(), 1U) << (found.empty() ? "nothing found" : found[0].message);
  EXPECT_NE(found[0].message.find(GetParam().message), std::string::npos) << found[0].message;
  EXPECT_EQ(found[0].position.line, GetParam().position.line);
  EXPECT_EQ(found[0].position.column, GetParam().position.column);
}

INSTANTIATE_TEST_SUITE_P(
    Names, TextSlips,
    ::testing::Values(
        Slip{"Global", "local x = confidense", "unknown name 'confidense' (did you mean 'confidence'?)", {1, 11}},
        Slip{"Field",
             "return function()\n  return robot.penalised\nend",
             "robot has no field 'penalised' (did you mean 'penalized'?)",
             {2, 16}},
        Slip{"FieldOfALocalName", "local c = confidence\nreturn c.curent", "confidence has no field 'curent'", {2, 10}},
        Slip{"Command",
             "return function() command.flip() end",
             "command has no field 'flip' (did you mean 'flip_pose'?)",
             {1, 27}},
        Slip{"LibraryFunction", "return math.sine(1)", "math has no field 'sine'", {1, 13}},
        Slip{"Param",
             "local p = param { lead = { 1 } }\nreturn p.leed",
             "unknown param 'leed' (did you mean 'lead'?)",
             {2, 10}},
        Slip{"ModuleFunction",
             "local walking = require \"lib.walk\"\nwalking.walk_too()",
             "lib.walk has no field 'walk_too'",
             {2, 9}},
        Slip{"Behavior", "return behaviors.othr.state", "unknown behavior 'othr' (did you mean 'other'?)", {1, 18}},
        Slip{"FieldOfABehavior",
             "return behaviors.other.stat",
             "behaviors.other has no field 'stat' (did you mean 'state'?)",
             {1, 24}},
        Slip{"State",
             "return behaviors.other.state == 'wating'",
             "behaviors.other.state: unknown value 'wating' (did you mean 'waiting'?)",
             {1, 33}},
        Slip{"StateOnTheLeft",
             "return \"wating\" ~= behaviors.other.state",
             "behaviors.other.state: unknown value 'wating'",
             {1, 8}},
        Slip{"Published",
             "return published.pose_is_serched",
             "no state publishes 'pose_is_serched' (did you mean 'pose_is_searched'?)",
             {1, 18}},
        Slip{"WrittenFlag", "published.pose_is_searched = true", "published.pose_is_searched is read-only", {1, 11}},
        Slip{"NamedValue", "return confidence.status == 'usible'", "'usible'", {1, 29}},
        Slip{"NamedValueOnTheLeft", "return 'up' ~= robot.posture", "'up'", {1, 8}},
        Slip{"NewGlobal", "count = 1", "unknown variable 'count': write 'local count'", {1, 1}},
        Slip{"NewGlobalFunction", "function helper() end", "unknown variable 'helper'", {1, 10}},
        Slip{"WrittenField", "robot.penalized = true", "robot.penalized is read-only", {1, 7}},
        Slip{"WrittenParam", "local p = param { a = {} }\np.a = 1", "param.a is read-only", {2, 3}},
        Slip{"ArgumentOfAWrongType",
             "head.look('left', 0)",
             "argument 1 of head.look: expected a number, found a string",
             {1, 11}},
        Slip{"TooFewArguments", "head.look(1)", "head.look: expected 2 arguments, found 1", {1, 10}},
        Slip{"TooManyArguments", "walk.stand(1)", "walk.stand: expected no argument, found 1", {1, 11}},
        Slip{"CommandInACondition",
             "return { when = function() return command.flip_pose() end }",
             "which a condition must not have",
             {1, 52}},
        Slip{"TableThatIsCalled", "log('x')", "log is a table, not a function: call log.info(text)", {1, 4}},
        Slip{"WorldTableThatIsCalled", "return pose()", "pose is a table, not a function: name one of its", {1, 12}},
        Slip{"FieldThatIsCalled", "return robot.posture()", "robot.posture is a string, not a function", {1, 21}},
        Slip{"ParamThatIsCalled",
             "local p = param { lead = { 1 } } return p.lead()",
             "param.lead is a number, not a function: write it without ( )",
             {1, 47}},
        Slip{"ParamOfALocalTable",
             "local all = { lead = { 1 } } local p = param(all) return p.laed",
             "unknown param 'laed'",
             {1, 60}},
        Slip{"ParamWithItsNameInBrackets",
             "local p = param { ['lead'] = { 1 } } return p.lead, p.leed",
             "unknown param 'leed'",
             {1, 55}},
        Slip{"FieldOfANumber", "return pose.x.y", "pose.x is a number and has no field 'y'", {1, 15}},
        Slip{"FieldOfAFunction", "return time_in_state.x", "is a function and has no field 'x': call it", {1, 22}},
        Slip{"Colon", "head:look(1, 0)", "head.look is called with a dot, not with ':'", {1, 6}},
        Slip{"MethodOfAString", "return robot.posture:uper()", "string has no field 'uper'", {1, 22}},
        Slip{"ArgumentOfTheLibrary",
             "return math.rad('90')",
             "argument 1 of math.rad: expected a number, found a string",
             {1, 17}},
        Slip{"MissingArgumentOfTheLibrary", "return math.fmod(1)", "math.fmod: expected 2 arguments, found 1", {1, 17}},
        Slip{
            "CalculatedArgument", "head.look(robot.posture, 0)", "argument 1 of head.look: expected a number", {1, 10}},
        Slip{"StringInArithmetic", "return pose.x + '1'", "'1' is a string, and '+' takes a number", {1, 17}},
        Slip{"BooleanInArithmetic", "return -robot.penalized", "robot.penalized is a boolean, and '-'", {1, 9}},
        Slip{"BooleanInAText", "return 'a' .. pose.known", "pose.known is a boolean, and '..' takes", {1, 15}},
        Slip{"UncalledFunctionInArithmetic",
             "local function lead() return 1 end return lead + 1",
             "lead is a function, and '+' takes a number: call it, lead()",
             {1, 43}},
        Slip{"NumberComparedWithAString", "return pose.x > '1'", "pose.x is a number and cannot be compared", {1, 17}},
        Slip{"NumberThatNeverEqualsAString", "return pose.x == '1'", "which is never equal to a string", {1, 18}},
        Slip{"FunctionAsACondition",
             "local function is_left() return true end if is_left then print(1) end",
             "is_left is a function, which is always true: call it, is_left()",
             {1, 45}},
        Slip{"FunctionAsTheResultOfACondition",
             "local function is_left() return true end return { when = function() return is_left end }",
             "is_left is a function, which is always true",
             {1, 76}},
        Slip{"FunctionAtTheEndOfACondition",
             "local function is_left() return true end if robot.penalized and is_left then print(1) end",
             "is_left is a function, which is always true",
             {1, 65}},
        Slip{"CountThatIsComparedWithAString",
             "local m = keep { n = 0 } return function() m.n = m.n + 1 return m.n > '2' end",
             "m.n is a number and cannot be compared with a string",
             {1, 71}},
        Slip{"CommandInAFunctionOfACondition",
             "local function flip() command.flip_pose() end return { when = function() return flip() end }",
             "flip has an effect, which a condition must not have",
             {1, 85}},
        Slip{"CommandAsACondition",
             "local function flip() command.flip_pose() end return { when = flip }",
             "flip has an effect, which a condition must not have",
             {1, 63}},
        Slip{"MissingArgumentOfAnOwnFunction",
             "local function half(x) return x / 2 end return half()",
             "half: expected 1 argument, found 0: half(x)",
             {1, 52}},
        Slip{"WrongArgumentOfAnOwnFunction",
             "local function half(x) return x / 2 end return half('a')",
             "argument 1 of half: expected a number, found a string",
             {1, 53}},
        Slip{"ArgumentTooMuchOfAnOwnFunction",
             "local function half(x) return x / 2 end return half(1, 2)",
             "half: expected 1 argument, found 2",
             {1, 52}},
        Slip{"ArgumentThatIsPassedOn",
             "local function look(yaw) head.look(yaw, 0) end return function() look() end",
             "look: expected 1 argument, found 0",
             {1, 70}},
        Slip{"FunctionBelowItsCaller",
             "local t = {} function t.a() return t.b() end function t.b(x) return x + 1 end return t",
             "t.b: expected 1 argument, found 0",
             {1, 39}},
        Slip{"ArgumentThatACallDoesNotReturn",
             "head.look(math.abs(pose.x))",
             "head.look: expected 2 arguments, found 1",
             {1, 10}},
        Slip{"FormatWithoutItsArgument",
             "return string.format('%s %.1f', pose.x)",
             "string.format: expected 2 arguments for this format, found 1",
             {1, 21}},
        Slip{"FormatOfAWrongType",
             "return ('%d%%'):format(robot.posture)",
             "argument 2 of string.format: expected a number, found a string",
             {1, 17}},
        Slip{"FieldOfAnOwnTable",
             "local memory = keep { looks = 0 } return memory.lokos",
             "memory.lokos is read but never written, so it is nil (did you mean 'looks'?)",
             {1, 49}},
        Slip{"DeclaredFieldOfAnOwnTable",
             "local m = keep { lokos = 0 } return function() m.looks = m.looks + 1 end",
             "'lokos' is written but never read (did you mean 'looks'?)",
             {1, 18}},
        Slip{"WrittenFieldOfAnOwnTable",
             "local m = keep { looks = 0 } return function() m.lokos = 0 return m.looks end",
             "'lokos' is written but never read (did you mean 'looks'?)",
             {1, 50}},
        Slip{"ResultOfAnOwnFunction",
             "local function lead() return pose.x - 1 end return lead() > '1'",
             "lead() is a number and cannot be compared with a string",
             {1, 61}},
        Slip{"AfterItsScope", "do local inner = 1 end\nreturn inner", "unknown name 'inner'", {2, 8}},
        Slip{"InALoopsHead", "for i = 1, numer do end", "unknown name 'numer'", {1, 12}},
        Slip{"InALongTextsNeighborhood", "local t = [==[ robot.falen\n]==] .. robt", "unknown name 'robt'", {2, 9}}),
    [](const auto& each) { return std::string(each.param.name); });

class CorrectScripts : public ::testing::TestWithParam<const char*> {};

TEST_P(CorrectScripts, GiveNoFindings) {
  for (const Finding& finding : check_text(GetParam(), known()).findings) ADD_FAILURE() << finding.text();
}

INSTANTIATE_TEST_SUITE_P(
    Names, CorrectScripts,
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
        "local t = setmetatable({}, { __call = function() return 1 end, __add = function() return 2 end }) "
        "return t() + 1, t + t, t.anything, t:anything()",
        "local C = {} C.__index = C function C.new() return setmetatable({ n = 1 }, C) end "
        "function C:get() return self.n end return C.new():get()",
        "local function f(x, y) return (x or 0) + (y and y * 2 or 1) end return f(), f(1), f(nil, 2)",
        "local function f(kind, x) if kind == 'a' then return 0 end return x + 1 end return f('a'), f('b', 1)",
        "local function f(x) x = x or 1 return x + 1 end return f()",
        "local function f(x) for _ = 1, 0 do print(x + 1) end end f()",
        "local function f(x) return type(x) == 'string' and x .. 'a' or x end return f('a'), f(1), f()",
        "local function f(x) local function g() return x + 1 end return g end return f()",
        "local function f(...) return select('#', ...) end return f(), f(1, 2, 3)",
        "local x = 1 x = 'a' return x .. 'b', #x", "local x x = 1 return x + 1",
        "local t = {} for _, k in ipairs { 'a', 'b' } do t[k] = 1 end return t.a + t.b",
        "local t = { a = 1 } table.insert(t, 2) return t.b",
        "local t = { a = 1 } for k, v in pairs(t) do print(k, v) end",
        "return string.format('%5.2f%% of %s', 1, nil), ('%d'):format(table.unpack { 1 }), string.format('100%%')",
        "local function two() return 1, 2 end return function() head.look(two()) head.look(table.unpack { 1, 2 }) end",
        "local f f = function(n) return n > 0 and f(n - 1) or 0 end return f(3)",
        "local p = param { a = { 1 }, b = { true }, c = { 'x' } } return p.a + 1, not p.b, p.c .. 'y', p.c == 'z'",
        "local t = { a = { 1 } } t.b = { 2 } local p = param(t) return p.a, p.b",
        "local done = nil if done then print(done.x) end return done == nil",
        "local a, b = (function() return 1, 2 end)() return a + b", "return ('%d'):format(3) .. robot.posture:upper()",
        "local c = robot.penalized and 1 or 'x' return c == 'x', c == 1", "return tostring(pose.x) == '1'",
        "local keys = { lying = true } return keys[robot.posture]",
        "local state_of = function(name) return behaviors[name].state end return state_of('other') == 'anything'",
        "local t = { speed1 = 1, speed2 = 2 } return t.speed1", "local t = { a = 1 } t.size = 2 return t.a",
        "local on = math.abs or print return on(1)", "local s = tostring(3) return s + 1, math.abs(s)",
        "return #behaviors.other.state + #'x'",
        "while robot.penalized do break end return function(...) return ... end"));

TEST(TextCheck, TerminatesOnAnyText) {
  for (const char* text :
       {"",   "end end", "local", "function", "x.",      "((((",          "for", "if",   "{",
        "}",  "a = = 3", "\"",    "[[",       "--[[",    "return return", "::",  "goto", "local function",
        "f(", "until",   "a,b",   "\\",       "\x80\xFF"}) {
    check_text(text, known());
  }
  check_text(std::string(100'000, '('), known());
  check_text(std::string(100'000, '{'), known());
  std::string nested;
  for (int i = 0; i < 10'000; ++i) nested += "do ";
  check_text(nested, known());
}

}  // namespace
}  // namespace reorient

// SPDX-License-Identifier: MIT
// Compares the string functions of scripts with Lua's own.
#include "engine/script/sandbox/pattern.h"

#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/script/sandbox/sandbox.h"

namespace reorient {
namespace {

/// All results of an expression as one text, in this Lua state.
std::string evaluate(lua_State* L, const std::string& expression) {
  const int top = lua_gettop(L);
  std::string out;
  if (luaL_loadstring(L, ("return " + expression).c_str()) != LUA_OK || lua_pcall(L, 0, LUA_MULTRET, 0) != LUA_OK) {
    out = "error";
  } else {
    for (int i = top + 1; i <= lua_gettop(L); ++i) {
      out += std::string(luaL_tolstring(L, i, nullptr)) + "|";
      lua_pop(L, 1);
    }
  }
  lua_settop(L, top);
  return out;
}

bool is_malformed(const std::string& text) {
  try {
    const Pattern pattern(text);
  } catch (const PatternError&) {
    return true;
  }
  return false;
}

class Patterns : public ::testing::Test {
 protected:
  Patterns() : original_(luaL_newstate()) {
    luaL_openlibs(original_);
    safe_.grant(1'000'000'000);
  }
  ~Patterns() override { lua_close(original_); }

  void expect_same(const std::string& expression) {
    EXPECT_EQ(evaluate(safe_.state(), expression), evaluate(original_, expression)) << expression;
  }

  Sandbox safe_{ScriptLimits{}};
  lua_State* original_;
};

/// A bug that tools/fuzz found: the end of a set and its ranges are searched one after the other.
TEST_F(Patterns, ParseSetsWithRangesThatEndInAPercentSignAsLuaDoes) {
  for (const char* pattern :
       {"[f[-%]]", "[a-%%]", "[!-%a]", "[%a-z]", "[a-]", "[]-a]", "[^]-a]", "[a-%]", "[%]-a]", "[--%]"}) {
    for (const char* subject : {"[f[-%]]", "]", "a", "%", "-", "z", "\"#", "m^"}) {
      expect_same(std::string("('") + subject + "'):find('" + pattern + "')");
    }
  }
}

TEST_F(Patterns, FindAndMatchAsLuaDoes) {
  for (const char* expression :
       {"('hello world'):find('o w')", "('hello'):find('l+')", "('hello'):find('(l)(l)')", "('hello'):find('')",
        "('hello'):find('', 6)", "('hello'):find('', 7)", "('hello'):find('x')", "('a.b'):find('.', 1, true)",
        "('a.b'):find('%.')", "('hello'):find('^l')", "('hello'):find('o$')", "('h$'):find('$$')",
        "('hello'):match('^(h)(.-)(o)$')", "('hello'):match('()ll()')", "('key = value'):match('^(%w+)%s*=%s*(%w+)$')",
        "('  x '):match('^%s*(.-)%s*$')", "('f(a(b)c)d'):match('%b()')", "('THE (quick) fox'):find('%f[%a]%a+%f[%A]')",
        "('\"a\\'b\"'):match('([\"\\'])(.-)%1')", "('2024-01-31'):match('(%d+)-(%d+)-(%d+)')", "('x]y'):match('[]]')",
        "('x^y'):match('[%^]')", "('a-z'):match('[a%-z]+')", "('abc'):match('[^a]+')", "('aXb'):match('%u')",
        "('0x1F'):match('%x+$')", "('a\\0b'):find('\\0')", "('a\\0b'):find('%z')", "('a\\0b'):match('%Z+')",
        "('abc'):match('((a)(b))')", "('hello'):find('l', -2)", "('hello'):find('h', -99)", "('abc'):match('a*?')",
        "('aaa'):match('a-b')", "('aaab'):match('a-b')", "('[test]'):match('^%[(.*)%]$')",
        // malformed patterns
        "('x'):find('[')", "('x'):find('[a')", "('x'):find('(')", "('x'):find(')')", "('x'):find('%')",
        "('x'):find('%b')", "('x'):find('%f')", "('x'):find('%1')", "('x'):find('[%')"}) {
    expect_same(expression);
  }
}

TEST_F(Patterns, ReplaceAsLuaDoes) {
  for (const char* expression :
       {"('hello'):gsub('l', 'L')", "('hello'):gsub('l', 'L', 1)", "('hello'):gsub('', '-')",
        "('hello'):gsub('x*', '-')", "('abc'):gsub('%w', '%0%0')", "('abc'):gsub('(a)(b)', '%2%1')",
        "('abc'):gsub('b', '%%')", "('abc'):gsub('b', { b = 'X' })", "('abc'):gsub('.', { a = 1, b = true == false })",
        "('abc'):gsub('%w', function(c) return c:upper() end)", "('abc'):gsub('%w', function() end)",
        "('hello world'):gsub('o', 'x', 0)", "('abc'):gsub('^a', 'x')", "('aaa'):gsub('^a', 'x')",
        "('abc'):gsub('()', '%1')", "('abc'):gsub('b', '%2')", "('abc'):gsub('b', {b = {}})",
        "('a b c'):gsub('%s*', '')"}) {
    expect_same(expression);
  }
}

TEST_F(Patterns, IterateOverAllMatchesAsLuaDoes) {
  const std::string collect =
      "(function(s, p) local all = '' for a, b in s:gmatch(p) do all = all .. tostring(a) .. ',' .. "
      "tostring(b) .. ';' end return all end)";
  for (const char* arguments : {"('one two three', '%a+')", "('k=v, x=y', '(%w+)=(%w+)')", "('abc', '')",
                                "('abc', 'x*')", "('', '')", "('a,b,,c', '([^,]*)')"}) {
    expect_same(collect + arguments);
  }
}

TEST_F(Patterns, RepeatAndFormatAsLuaDoes) {
  for (const char* expression :
       {"('ab'):rep(3)", "('ab'):rep(3, '-')", "('ab'):rep(0)", "('ab'):rep(-1)", "('ab'):rep(1, '-')", "(''):rep(5)",
        "(''):rep(3, 'x')", "('%5.2f|%d|%s|%q|%x'):format(3.14159, 42, 'hi', 'a\\nb', 255)",
        "('%s %s'):format(nil, true)", "('%d'):format(1.5)", "('%s'):format()", "('%%'):format()"}) {
    expect_same(expression);
  }
}

RC_GTEST_FIXTURE_PROP(Patterns, ARandomPatternMatchesAsInLua, ()) {
  const std::string letters = "ab.*+-?()[]^$%ad1";
  const auto pattern = *rc::gen::resize(11, rc::gen::container<std::string>(rc::gen::elementOf(letters)));
  const auto subject = *rc::gen::resize(11, rc::gen::container<std::string>(rc::gen::element('a', 'b', '1', '(')));
  for (const char* function : {"find", "match"}) {
    std::string expression = "string.";
    expression.append(function).append("('").append(subject).append("', '").append(pattern).append("')");
    const std::string seen = evaluate(safe_.state(), expression);
    // Lua detects a malformed pattern only if a search reaches the position; here it is refused before the search.
    if (seen != "error") RC_ASSERT(seen == evaluate(original_, expression));
    if (seen == "error") RC_ASSERT(is_malformed(pattern));
  }
}

TEST(Pattern, EveryStepHasACost) {
  std::int64_t steps = 1000;
  EXPECT_THROW(Pattern(".-.-.-b").search(std::string(700, 'a'), 0, steps), PatternTooCostly);
  EXPECT_LT(steps, 0);
}

}  // namespace
}  // namespace reorient

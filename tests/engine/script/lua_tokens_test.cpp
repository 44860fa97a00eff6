// SPDX-License-Identifier: MIT
// The tokens of a script and their positions.
#include "engine/script/source/lua_tokens.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/script/source/source_locations.h"

namespace reorient {
namespace {

using Kind = LuaToken::Kind;

std::vector<std::string> texts(std::string_view text) {
  std::vector<std::string> all;
  for (const LuaToken& token : lua_tokens(text)) all.push_back(token.text);
  all.pop_back();  // the end
  return all;
}

TEST(LuaTokens, AreSplitAsLuaDoes) {
  EXPECT_EQ(texts("a.b..c...d"), (std::vector<std::string>{"a", ".", "b", "..", "c", "...", "d"}));
  EXPECT_EQ(texts("x=0x1p-4+1e+3-3.5//2"),
            (std::vector<std::string>{"x", "=", "0x1p-4", "+", "1e+3", "-", "3.5", "//", "2"}));
  EXPECT_EQ(texts("0xe-1"), (std::vector<std::string>{"0xe", "-", "1"}));
  EXPECT_EQ(texts("'it''s' \"a\\\"b\""), (std::vector<std::string>{"it", "s", "a\\\"b"}));
  EXPECT_EQ(texts("[[a]b]] [==[c]]d]==]"), (std::vector<std::string>{"a]b", "c]]d"}));
  EXPECT_EQ(texts("#!shell\nx -- y\n--[[ z\n]] w --[=[ ]] ]=] v"), (std::vector<std::string>{"x", "w", "v"}));
  EXPECT_EQ(texts("a<=b>=c~=d::e<<f"),
            (std::vector<std::string>{"a", "<=", "b", ">=", "c", "~=", "d", "::", "e", "<<", "f"}));
}

TEST(LuaTokens, HaveTheirType) {
  const std::vector<LuaToken> tokens = lua_tokens("local name = 'text' .. 3");
  EXPECT_TRUE(tokens[0].is_keyword("local"));
  EXPECT_TRUE(tokens[1].is(Kind::name, "name"));
  EXPECT_TRUE(tokens[2].is_symbol("="));
  EXPECT_TRUE(tokens[3].is(Kind::text, "text"));
  EXPECT_TRUE(tokens[5].is(Kind::number, "3"));
  EXPECT_EQ(tokens[6].kind, Kind::end);
}

TEST(LuaTokens, HaveLinesAndColumnsThatStartAtOne) {
  const std::vector<LuaToken> tokens = lua_tokens("a\n  bc [[x\ny]] d");
  EXPECT_EQ(tokens[1].position.line, 2);
  EXPECT_EQ(tokens[1].position.column, 3);
  EXPECT_EQ(tokens[3].position.line, 3);
  EXPECT_EQ(tokens[3].position.column, 5);
}

RC_GTEST_PROP(LuaTokensProperty, AreInOrderAtTheirPositionsForAnyText, ()) {
  const auto pieces = *rc::gen::container<std::vector<std::string>>(
      rc::gen::element<std::string>("a", "when", "=", "{", "}", "(", ")", "\"x\"", "'y'", "[[z]]", "--c\n", "\n", " ",
                                    ".", "..", "3", "\\", "\"", "[", "]", "-", "\x80", "state", "=="));
  std::string text;
  for (const std::string& piece : pieces) text += piece;
  std::vector<std::string> lines{""};
  for (const char letter : text) {
    if (letter == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += letter;
    }
  }
  TextPosition before{0, 0};
  for (const LuaToken& token : lua_tokens(text)) {
    RC_ASSERT(is_before(before, token.position));
    before = token.position;
    if (token.kind == Kind::end) break;
    const std::string& line = lines.at(static_cast<std::size_t>(token.position.line) - 1);
    const auto column = static_cast<std::size_t>(token.position.column) - 1;
    if (token.kind == Kind::text) {
      RC_ASSERT(line[column] == '"' || line[column] == '\'' || line[column] == '[');
    } else {
      RC_ASSERT(line.compare(column, token.text.size(), token.text) == 0);
    }
  }
}

TEST(SourceLocations, FindsTransitionsToOneTargetInTheirOrder) {
  const SourceLocations places(R"(behavior "b" {
  common = { { "x", when = f } },
  state "x" {
    { "y", when = f }, { "y", after = 1 },
    state "inner" { { "y", after = 2 } },
  },
  { "y", after = 3 },
})");
  SourceLocations::Table machine = places.table("behavior", "b", 1);
  EXPECT_EQ(places.transition(machine, "x", true)->line, 2);
  EXPECT_EQ(places.transition(machine, "y", false)->line, 7);
  SourceLocations::Table x = places.table("state", "x", 3);
  EXPECT_EQ(places.transition(x, "y", false)->column, 7);
  EXPECT_EQ(places.transition(x, "y", false)->column, 26);
  EXPECT_FALSE(places.transition(x, "y", false)) << "the text has only two transitions";
  SourceLocations::Table inner = places.table("state", "inner", 5);
  EXPECT_EQ(places.transition(inner, "y", false)->line, 5);
}

TEST(SourceLocations, FindsTheLineOfAStateThatAFunctionMade) {
  const SourceLocations places("state \"a\" (make())\nstate(name) {}\n");
  SourceLocations::Table made = places.table("state", "a", 1);
  EXPECT_EQ(made.position.column, 7);
  EXPECT_FALSE(places.transition(made, "b", false));
  const SourceLocations::Table unknown = places.table("state", "b", 2);
  EXPECT_EQ(unknown.position.line, 2);
  EXPECT_EQ(unknown.position.column, 0);
}

}  // namespace
}  // namespace reorient

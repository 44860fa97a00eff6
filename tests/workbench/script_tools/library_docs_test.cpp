// SPDX-License-Identifier: MIT
// Doc comments of libraries as data, for the reference and for editors.
#include "workbench/script_tools/reference/library_docs.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/parameters/utf8.h"
#include "engine/script/sandbox/sandbox.h"
#include "workbench/script_tools/reference/script_reference.h"

namespace reorient {
namespace {

std::vector<std::string> names(const LibraryModule& module) {
  std::vector<std::string> all;
  for (const LibraryMember& member : module.members) all.push_back(member.name);
  return all;
}

DocComment doc(const std::vector<std::string_view>& lines) { return doc_comment(lines); }

TEST(LibraryDocs, ContainArgumentsAndResultsOfAFunction) {
  const LibraryModule module = library_module("lib.way", R"(--- Ways over
--- the field.

local way = {}

--- Walks there.
---@param x number m
---@param how? "fast"|"slow" # how fast
---@return boolean has_arrived
---@return number distance m, to the target
function way.walk_to(x, how) return true, x end

return way
)");
  EXPECT_EQ(module.name, "lib.way");
  EXPECT_EQ(module.description, "Ways over the field.");
  ASSERT_EQ(names(module), std::vector<std::string>{"walk_to"});
  const LibraryMember& walk_to = module.members.front();
  EXPECT_TRUE(walk_to.is_function);
  EXPECT_EQ(walk_to.parameters, (std::vector<std::string>{"x", "how"}));
  EXPECT_EQ(walk_to.doc.description, "Walks there.");
  ASSERT_EQ(walk_to.doc.parameters.size(), 2U);
  EXPECT_EQ(walk_to.doc.parameters[0].type, "number");
  EXPECT_EQ(walk_to.doc.parameters[0].description, "m");
  EXPECT_EQ(walk_to.doc.parameters[1].name, "how");
  EXPECT_TRUE(walk_to.doc.parameters[1].is_optional);
  EXPECT_EQ(walk_to.doc.parameters[1].type, "\"fast\"|\"slow\"");
  EXPECT_EQ(walk_to.doc.parameters[1].description, "how fast");
  ASSERT_EQ(walk_to.doc.results.size(), 2U);
  EXPECT_EQ(walk_to.doc.results[0].name, "has_arrived");
  EXPECT_EQ(walk_to.doc.results[1].description, "m, to the target");
}

TEST(LibraryDocs, TakeTheFirstDocCommentAsTheDescription) {
  const auto description = [](const std::string& text) { return library_module("lib.way", text).description; };
  EXPECT_EQ(description("-- SPDX-License-Identifier: MIT\n\n--- Ways.\n--- Over the field.\nlocal way = {}\n"),
            "Ways. Over the field.");
  EXPECT_EQ(description("--[[ A plain\ncomment. ]]\n--- Ways.\nlocal way = {}\n"), "Ways.");
  EXPECT_EQ(description("\xEF\xBB\xBF--- Ways.\nlocal way = {}\n"), "Ways.");
  EXPECT_EQ(description("-- plain\nlocal way = {}\n--- Of a function.\nfunction way.go() end\nreturn way\n"), "");
  EXPECT_EQ(description("-- plain\n--- Of a function.\nlocal function go() end\nreturn { go = go }\n"), "");
  EXPECT_EQ(description("--- Only this."), "Only this.");
  EXPECT_EQ(description(""), "");
}

TEST(LibraryDocs, AcceptTypesWithBlanks) {
  EXPECT_EQ(doc({"---@param f fun(x: number, y: number): boolean asks"}).parameters[0].type,
            "fun(x: number, y: number): boolean");
  EXPECT_EQ(doc({"---@param t { x: number, y: number } a place"}).parameters[0].description, "a place");
  EXPECT_EQ(doc({"---@param t table<string, number>"}).parameters[0].type, "table<string, number>");
  EXPECT_TRUE(doc({"---@param t number | nil m"}).parameters[0].is_optional);
  EXPECT_EQ(doc({"--- @param t \"a b\" | 'c d' one"}).parameters[0].type, "\"a b\" | 'c d'");
  EXPECT_EQ(doc({"---@return number # m"}).results[0].description, "m");
  EXPECT_EQ(doc({"---@type number[]"}).type, "number[]");
}

TEST(LibraryDocs, FindEachSyntaxOfAMember) {
  const LibraryModule module = library_module("lib.ways", R"(
local ways = {
  --- In the table.
  inner = function(a) return a end,
  --- A value there.
  limit = 3,
}
--- As a field.
ways.field = function(b, ...) return b end
--- A value.
ways.START = { x = 1, inner = { y = 2 } }
--- As a method.
function ways:turn(c) return c end
--- A local one.
local function hidden(d) return d end
ways.shown = hidden
function ways.bare() if true then ways.late = function() end end end
--- Not for others.
function ways._private() end
--- Of another table.
function other.function_of_another() end
return ways
)");
  EXPECT_EQ(names(module), (std::vector<std::string>{"inner", "limit", "field", "START", "turn", "shown", "bare"}));
  const auto& members = module.members;
  EXPECT_EQ(members[0].doc.description, "In the table.");
  EXPECT_FALSE(members[1].is_function);
  EXPECT_EQ(members[2].parameters, (std::vector<std::string>{"b", "..."}));
  EXPECT_EQ(members[3].doc.description, "A value.");
  EXPECT_TRUE(members[4].is_method);
  EXPECT_EQ(members[5].doc.description, "A local one.");
  EXPECT_EQ(members[5].parameters, std::vector<std::string>{"d"});
  EXPECT_TRUE(members[6].doc.lines.empty());
}

TEST(LibraryDocs, FindMembersOfATableThatIsReturnedDirectly) {
  const LibraryModule module = library_module("lib.t", R"(local function f(x) return x end
return {
  --- One.
  one = f,
  two = function() local a, b = 1, 2 return { c = a } end; three = 3,
})");
  EXPECT_EQ(names(module), (std::vector<std::string>{"one", "two", "three"}));
  EXPECT_EQ(module.members[0].doc.description, "One.");
  EXPECT_EQ(names(library_module("lib.m", "local m = {} function m.f() end return setmetatable(m, {})")),
            std::vector<std::string>{"f"});
}

TEST(LibraryDocs, DoNotMistakeTextForAComment) {
  const LibraryModule module = library_module("lib.t", R"(local t = {}
local text = [[
--- This is text.
]] function t.f() end
t.x = 1 --- behind a value
function t.g() end
-- A plain comment.
function t.h() end
return t)");
  EXPECT_EQ(names(module), (std::vector<std::string>{"f", "x", "g", "h"}));
  for (const LibraryMember& member : module.members) EXPECT_TRUE(member.doc.lines.empty()) << member.name;
}

TEST(LibraryDocs, DoNotMistakeTheCommentOfTheFirstFunctionForThatOfTheFile) {
  EXPECT_EQ(library_module("lib.t", "--- Of f.\nfunction t.f() end\nreturn t").description, "");
  EXPECT_EQ(
      library_module("lib.t", "#!/usr/bin/lua\n\n-----------\n--- Of all.\n-----------\nlocal t = {}").description,
      "Of all.");
}

std::string annotations(const std::string& text) {
  const std::vector<LibraryModule> modules{library_module("lib.odd", text), library_module("lib.odd_too", text)};
  EXPECT_TRUE(is_utf8(script_reference(modules)));
  return script_annotations(modules);
}

bool is_lua(const std::string& text) {
  ScriptLimits limits;
  limits.max_memory = 64 * 1024;
  Sandbox sandbox(limits);
  const std::optional<ScriptFault> fault = sandbox.compile(text, "annotations");
  return !fault;
}

TEST(LibraryDocs, ContainWhatIsFoundInInvalidLua) {
  const std::string deep(60'000, '(');
  std::string many;
  for (int i = 0; i < 3000; ++i) many += "function m.f" + std::to_string(i) + "() end\n";
  for (const std::string& text :
       {std::string(), std::string("return"), std::string("function m."), std::string("end end end return {"),
        std::string("local m = { a = function( return m"),
        std::string("--- \xFF\xFE\n---@param\nfunction m.f(x) end return m"),
        std::string("---@param x fun((((\n---@return \"\nfunction m.f(x) end return m"),
        std::string("--- a\0b\x1B[31m\r\nfunction m.f() end\r\nreturn m\r\n", 43), deep, "function m.f(" + deep,
        "---@param x " + deep + "\nfunction m.f(x) end return m", many + "return m"}) {
    EXPECT_TRUE(is_lua(annotations(text))) << text.substr(0, 60);
  }
  EXPECT_EQ(names(library_module("lib.m", "function m.f() end end\nfunction m.g() end return m")),
            (std::vector<std::string>{"f", "g"}));
}

RC_GTEST_PROP(LibraryDocs, MakeValidAnnotationsOfAnyText, ()) {
  const auto pieces = *rc::gen::container<std::vector<std::string>>(
      rc::gen::element<std::string>("--- d", "---@param x ", "---@return ", "\n", "\n", "local m = {", "}",
                                    "function m.f(", "function m:g(", "x", "...", ")", " end", "return m", "return {",
                                    "f = ", "function(", ",", "]]", "--[[", "\"", "if ", "\xFF", "`|", "(", "m.y = "));
  std::string text;
  for (const std::string& piece : pieces) text += piece;
  RC_ASSERT(is_lua(annotations(text)));
}

TEST(LibraryDocs, AreWrittenToTheReferenceAndTheAnnotations) {
  const std::vector<LibraryModule> modules{library_module("lib.way", R"(--- Ways.

local way = {}
--- Goes | there.
---@param x? number m
---@return table<string, number> found
function way.go(x) end
--- Where.
---@type number
way.HERE = 1
return way)")};
  const std::string page = script_reference(modules);
  EXPECT_NE(page.find("### `lib.way`\nWays.\n\n"
                      "| name | arguments | result | what it is |\n|---|---|---|---|\n"
                      "| `go(x?)` | `x: number` m | `found: table<string, number>` | Goes \\| there. |\n"
                      "| `HERE` |  | `number` | Where. |\n\n"),
            std::string::npos)
      << page.substr(page.find("## Libraries"), 600);
  const std::string text = script_annotations(modules);
  EXPECT_NE(text.find("---Ways.\n---@class lib.way\nlocal library = {}\n\n"
                      "--- Goes | there.\n---@param x? number m\n---@return table<string, number> found\n"
                      "function library.go(x) end\n\n--- Where.\n---@type number\nlibrary.HERE = nil\nend\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("---@overload fun(module: \"lib.way\"): lib.way\n"), std::string::npos) << text;
}

TEST(LibraryDocs, AreReadFromFilesBelowLibThatCanBeRequired) {
  ScriptTexts texts;
  for (const char* file : {"lib/a.lua", "lib/deep/b.lua", "lib/not-a-name.lua", "behaviors/c.lua"})
    texts.apply({file, ScriptText{"return { x = 1 }", ""}});
  texts.apply({"lib/unusable.lua", ScriptText{"", "this is not a plain file"}});
  std::vector<std::string> found;
  for (const LibraryModule& module : library_modules(texts)) found.push_back(module.name);
  EXPECT_EQ(found, (std::vector<std::string>{"lib.a", "lib.deep.b", "lib.unusable"}));
  EXPECT_EQ(library_modules(texts).back().description, "this is not a plain file");
}

}  // namespace
}  // namespace reorient

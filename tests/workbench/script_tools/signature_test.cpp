// SPDX-License-Identifier: MIT
// Signatures in the notation of the vocabulary.
#include "workbench/script_tools/reference/signature.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "workbench/script_tools/reference/vocabulary.h"

namespace reorient {
namespace {

TEST(Signature, IsReadWithOptionalArgumentsAndResult) {
  const Signature read = read_signature("expect.near(actual: number, tolerance?: number, ...: any): boolean is_near");
  EXPECT_EQ(read.full_name(), "expect.near");
  ASSERT_EQ(read.arguments.size(), 3U);
  EXPECT_EQ(read.arguments[0].type, "number");
  EXPECT_EQ(read.arguments[1].name, "tolerance");
  EXPECT_EQ(read.arguments[1].type, "number?");
  EXPECT_EQ(read.arguments[2].name, "...");
  EXPECT_EQ(read.result, "boolean is_near");
}

TEST(Signature, KeepsTypesWithBracketsTogether) {
  const Signature read = read_signature("f(a: { b: string, c: number? }, d: fun(x: table<string, any>): string): any");
  ASSERT_EQ(read.arguments.size(), 2U);
  EXPECT_EQ(read.arguments[0].type, "{ b: string, c: number? }");
  EXPECT_EQ(read.arguments[1].type, "fun(x: table<string, any>): string");
}

TEST(Signature, RejectsInvalidText) {
  for (const char* text : {"", "name", "f(", "f(a)", "f(a: number", "f(: number)"})
    EXPECT_THROW(read_signature(text), std::invalid_argument) << text;
}

TEST(Signature, OfEveryKeywordCanBeRead) {
  for (const auto& words : {language_words(), test_words()}) {
    for (const ScriptWord& word : words) {
      if (!word.is_function()) continue;
      EXPECT_EQ(read_signature(word.signature).full_name(), word.name());
    }
  }
  for (const LibraryRow& row : library_rows()) {
    for (const std::string_view text : row.signatures) {
      if (text.find('(') == std::string_view::npos) continue;
      EXPECT_EQ(read_signature(text).table, row.table) << text;
    }
  }
}

TEST(Signature, BecomesADefinitionForEditors) {
  EXPECT_EQ(to_annotation(read_signature("expect.command(name: string, verdict?: string): boolean")),
            "---@param name string\n---@param verdict? string\n---@return boolean\n"
            "function expect.command(name, verdict) end");
}

}  // namespace
}  // namespace reorient

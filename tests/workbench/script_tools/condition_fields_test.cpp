// SPDX-License-Identifier: MIT
// The world fields that conditions read, by the texts of scripts.
#include "workbench/script_tools/graph/condition_fields.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace reorient {
namespace {

using FieldNames = std::vector<std::string>;
constexpr const char* kReadingFile = "behaviors/b.lua";

ScriptTexts texts_of(const std::string& behavior, const std::string& library = "") {
  ScriptTexts texts;
  texts.apply({kReadingFile, ScriptText{behavior, ""}});
  if (!library.empty()) texts.apply({"lib/limits.lua", ScriptText{library, ""}});
  return texts;
}

FieldNames read_at(const ScriptTexts& texts, int line, int column = 0) {
  return ConditionFields(texts).read_at(kReadingFile, {line, column});
}

TEST(FieldsRead, AreThoseOfTheConditionAndItsLocalFunctions) {
  const ScriptTexts texts = texts_of(R"(local function lost()
  return confidence.status == "lost" or not pose.known
end
local far = function() return pose.x > 3 end
behavior "b" {
  state "a" {
    { "c", when = function() return confidence.evidence > lib.limit and robot.penalized and robot.nothing end },
    { "d",
      when = lost, because = "pose.y" },
    { "e", when = function() return far() or lost() or pose.x < 0 end }, { "f", when = function() return clock.time end },
  },
})");
  EXPECT_EQ(read_at(texts, 7), (FieldNames{"confidence.evidence", "robot.penalized"}));
  EXPECT_EQ(read_at(texts, 8), (FieldNames{"confidence.status", "pose.known"}));
  EXPECT_EQ(read_at(texts, 10), (FieldNames{"pose.x", "confidence.status", "pose.known"}));
  EXPECT_EQ(read_at(texts, 10, 7), (FieldNames{"pose.x", "confidence.status", "pose.known"})) << "of its target";
  EXPECT_EQ(read_at(texts, 10, 76), FieldNames{"clock.time"}) << "the second transition of the line";
  EXPECT_EQ(read_at(texts, 6, 9), FieldNames()) << "a state is no transition";
  for (const int line : {-1, 0, 1, 99}) EXPECT_EQ(read_at(texts, line), FieldNames()) << line;
}

TEST(FieldsRead, AreAlsoThoseOfFunctionsOfLibraries) {
  const ScriptTexts texts = texts_of(R"(local limits = require "lib.limits"
local again = require("lib.limits")
behavior "b" {
  state "a" {
    { "b", when = function() return limits.is_high() and pose.known end },
    { "c", when = limits.is_low },
    { "d", when = function() return again.is_far() or limits.unknown() end },
  },
})",
                                     R"(local limits = {}
local function most() return robot.head_yaw end
function limits.is_high() return confidence.evidence > most() end
limits.is_low = function()
  return not limits.is_high()
end
function limits.is_far() return pose.x > 3 end
return limits
)");
  EXPECT_EQ(read_at(texts, 5), (FieldNames{"confidence.evidence", "robot.head_yaw", "pose.known"}));
  EXPECT_EQ(read_at(texts, 6), (FieldNames{"confidence.evidence", "robot.head_yaw"}));
  EXPECT_EQ(read_at(texts, 7), FieldNames{"pose.x"});
}

TEST(FieldsRead, EndWithUnusualText) {
  EXPECT_EQ(read_at(texts_of(""), 1), FieldNames());
  EXPECT_EQ(read_at(texts_of("{ pose.x"), 1), FieldNames{"pose.x"});
  EXPECT_EQ(read_at(texts_of("{ a() } local function a() return a() or b() end local function b() return a() end"), 1),
            FieldNames());
  EXPECT_EQ(read_at(texts_of("local a = require\n{ a.b() }"), 2), FieldNames());
  EXPECT_EQ(read_at(texts_of("local l = require 'lib.limits'\n{ l.a() }",
                             "local l = require 'lib.limits'\n"
                             "function l.a() return l.a(), pose.y end"),
                    2),
            FieldNames{"pose.y"})
      << "a library that requires itself";
  EXPECT_EQ(read_at(texts_of("local l = require 'lib.missing'\n{ l.a() or pose.y }"), 2), FieldNames{"pose.y"});
  EXPECT_EQ(ConditionFields(ScriptTexts()).read_at("behaviors/b.lua", {1, 1}), FieldNames()) << "an unknown file";
  std::string deep = "{ f0() }\n";
  for (int i = 0; i < 500; ++i)
    deep += "local function f" + std::to_string(i) + "() return f" + std::to_string(i + 1) + "() end\n";
  EXPECT_EQ(read_at(texts_of(deep), 1), FieldNames());
}

}  // namespace
}  // namespace reorient

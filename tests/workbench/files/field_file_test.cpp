// SPDX-License-Identifier: MIT
#include "workbench/files/field_file.h"

#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

const std::filesystem::path kFields = std::filesystem::path(kSourceFolder) / "assets" / "fields";

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// The error message of loading; empty: success.
std::string complaint(const std::filesystem::path& file) {
  try {
    load_field(file);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

std::string complaint_about(std::string_view text) {
  const TemporaryFolder folder;
  return complaint(folder.write("field.toml", text));
}

std::string with(std::string_view key, std::string_view value, std::string_view before = "") {
  std::istringstream lines(text_of(kFields / "spl.toml"));
  std::string line, text;
  while (std::getline(lines, line)) {
    const bool hit = line.rfind(std::string(key) + " ", 0) == 0;
    text += hit ? std::string(before) + std::string(key) + " = " + std::string(value) + "\n" : line + "\n";
  }
  return text;
}

TEST(FieldFile, OfTodayHasTheDefaultsOfTheCode) {
  const FieldDimensions file = load_field(kFields / "spl.toml");
  const FieldDimensions code;
  EXPECT_EQ(file.length, code.length);
  EXPECT_EQ(file.width, code.width);
  EXPECT_EQ(file.border, code.border);
  EXPECT_EQ(file.line_width, code.line_width);
  EXPECT_EQ(file.penalty_area_depth, code.penalty_area_depth);
  EXPECT_EQ(file.penalty_area_width, code.penalty_area_width);
  EXPECT_EQ(file.goal_area_depth, code.goal_area_depth);
  EXPECT_EQ(file.goal_area_width, code.goal_area_width);
  EXPECT_EQ(file.penalty_mark_x, code.penalty_mark_x);
  EXPECT_EQ(file.center_circle_radius, code.center_circle_radius);
  EXPECT_EQ(file.goal_post_y, code.goal_post_y);
  EXPECT_EQ(file.yellow_goals, code.yellow_goals);
}

TEST(FieldFile, OfThePaperHasYellowGoalsAndASmallPenaltyArea) {
  const FieldDimensions field = load_field(kFields / "spl-2013.toml");
  EXPECT_TRUE(field.yellow_goals);
  EXPECT_DOUBLE_EQ(field.penalty_area_depth, 0.6);
  EXPECT_DOUBLE_EQ(field.penalty_mark_x, 2.7);
}

TEST(FieldFile, OfARuleBookIsReadToTheMiddleOfItsLines) {
  const FieldDimensions field = load_field(kFields / "middle.toml");
  EXPECT_DOUBLE_EQ(field.length, 13.95);
  EXPECT_DOUBLE_EQ(field.width, 8.95);
  EXPECT_DOUBLE_EQ(field.border, 1.025);
  EXPECT_DOUBLE_EQ(field.penalty_area_depth, 2.95);
  EXPECT_DOUBLE_EQ(field.penalty_area_width, 5.95);
  EXPECT_DOUBLE_EQ(field.center_circle_radius, 1.475);
  EXPECT_DOUBLE_EQ(field.corner_arc_radius, 0.475);
  EXPECT_DOUBLE_EQ(field.penalty_mark_x, 5.0);
}

TEST(FieldFile, OfEveryShippedFieldIsInOrder) {
  int fields = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFields)) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_EQ(complaint(entry.path()), "");
    ++fields;
  }
  EXPECT_GE(fields, 5);
}

TEST(FieldFile, ContainsToWhichPartOfALineItIsMeasured) {
  EXPECT_NE(complaint_about(with("measured_to", "\"inside\""))
                .find("measured_to: expected \"middle of lines\" or \"outside of lines\", found 'inside'"),
            std::string::npos);
}

TEST(FieldFile, ThatIsTooSmallWithoutItsLinesIsRefused) {
  const std::string text = with("length", "2.0");
  EXPECT_EQ(complaint_about(text), "");
  std::string outside = text;
  outside.replace(outside.find("middle of"), 9, "outside of");
  EXPECT_NE(
      complaint_about(outside).find("'length' must be a number from 2 to 120 meters between the middles of lines"),
      std::string::npos);
}

TEST(FieldFile, ThatIsMissingIsNamedInOneLine) {
  const std::string text = complaint("nowhere/field.toml");
  EXPECT_NE(text.find("nowhere/field.toml"), std::string::npos);
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(FieldFile, ThatIsNotTomlIsRefusedWithItsLine) {
  EXPECT_NE(complaint_about("length = 9.0\nwidth = = 6").find(":2: "), std::string::npos);
  EXPECT_NE(complaint_about(std::string("\0\xff\x01", 3)), "");
}

TEST(FieldFile, WithAKeyOfAHundredThousandPartsDoesNotExhaustTheStack) {
  std::string key = "a";
  for (int i = 0; i < 100'000; ++i) key += ".a";
  EXPECT_NE(
      complaint_about("\n" + key + " = 1").find(":2: expected a line of at most 1000 letters, found a longer one"),
      std::string::npos);
}

TEST(FieldFile, ReportsAnUnknownKeyOnOneLine) {
  const std::string text = complaint_about("\"\\u001b[2J\\n\" = 1");
  EXPECT_NE(text.find("unknown key '\\x1B[2J '"), std::string::npos) << text;
}

TEST(FieldFile, WithoutAKeyIsRefusedWithTheKeysName) {
  EXPECT_NE(complaint_about(with("length", "9.0", "# ")).find("expected the key 'length', found none"),
            std::string::npos);
}

TEST(FieldFile, WithAnUnknownKeyIsRefused) {
  EXPECT_NE(complaint_about(text_of(kFields / "spl.toml") + "\nlenght = 3\n").find("'lenght'"), std::string::npos);
}

TEST(FieldFile, WithAValueOutOfRangeOrOfTheWrongTypeIsRefused) {
  for (const char* value : {"-9.0", "1e9", "nan", "inf", "\"nine\"", "true", "[9.0]"}) {
    EXPECT_NE(complaint_about(with("length", value)).find("length: expected a number from 2 to 120"), std::string::npos)
        << value;
  }
  EXPECT_NE(complaint_about(with("yellow_goals", "1")).find("yellow_goals: expected true or false, found 1"),
            std::string::npos);
}

}  // namespace
}  // namespace reorient

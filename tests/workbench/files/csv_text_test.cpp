// SPDX-License-Identifier: MIT
#include "workbench/files/csv_text.h"

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "engine/parameters/parameter.h"

namespace reorient {
namespace {

TEST(CsvCell, IsQuotedIfNecessary) {
  EXPECT_EQ(csv_cell("plain"), "plain");
  EXPECT_EQ(csv_cell(""), "");
  EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_cell("say \"no\""), "\"say \"\"no\"\"\"");
  EXPECT_EQ(csv_cell("two\nlines"), "\"two\nlines\"");
}

TEST(CsvCell, IsNoFormulaOfASpreadsheet) {
  for (const std::string text : {"=1+1", "@SUM(A1)", "+cmd|' /C calc'!A0", "-2+3", "=", "-", "+", "--1", "-1e", "- 1"})
    EXPECT_EQ(csv_cell(text), "\"'" + text + "\"") << text;
  EXPECT_EQ(csv_cell("=\"x\""), "\"'=\"\"x\"\"\"");
  for (const std::string blank : {" ", "\t", "\r", "\n", " \t\r\n"})
    EXPECT_EQ(csv_cell(blank + "=1"), "\"'" + blank + "=1\"");
  EXPECT_EQ(csv_cell("a=b"), "a=b");
  EXPECT_EQ(csv_cell("\xC3\xA9=1"), "\xC3\xA9=1");
}

TEST(CsvCell, OfANumberIsUnchanged) {
  for (const std::string text : {"-1", "+1", "-0.5", "-1e-9", "-1e999", "-inf", "+inf", "-nan", "0", "12"})
    EXPECT_EQ(csv_cell(text), text);
}

TEST(ParameterText, OfWhatIsNotANumberHasNoSign) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(to_text(ParameterValue(kNan)), "nan");
  EXPECT_EQ(to_text(ParameterValue(-kNan)), "nan");
  EXPECT_EQ(to_text(ParameterValue(-1.5)), "-1.5");
}

}  // namespace
}  // namespace reorient

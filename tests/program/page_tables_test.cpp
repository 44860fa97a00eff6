// SPDX-License-Identifier: MIT
// Tables of a page that are generated from stored results, among them the tables of docs/evidence/.
#include "program/experiment/outputs/page_tables.h"

#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/paths.h"
#include "tests/program/child_program.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

constexpr const char* kRows = R"([
  {"test": "head only", "mode": "default", "trials": 100, "failed": 0.02, "failed_low": 0.0061, "failed_high": 0.07,
   "mean_s": 2.26, "right_mean_s": 3.04, "right_mean_low": 2.5, "right_mean_high": 3.96, "right_hours": 1.234,
   "false_flips_per_hour_low": 0.0, "false_flips_per_hour_high": null, "flip": 0.98},
  {"test": "a | b", "mode": "none", "trials": 100, "failed": 1.0, "failed_low": 0.96, "failed_high": 1.0,
   "mean_s": null, "right_mean_s": null, "right_mean_low": null, "right_mean_high": null, "right_hours": 0.0,
   "false_flips_per_hour_low": 0.0, "false_flips_per_hour_high": 3.0, "flip": 0.0}
])";
constexpr const char* kRun = R"({"command": "reorient experiment table1", "commit": "abc", "seeds": "1 to 100",
                                 "machine": "a computer", "when": "2026-11-22"})";

const std::map<std::string, std::string> kFiles{
    {"t.json", kRows}, {"run.json", kRows}, {"run.run.json", kRun}, {"bad.json", "[{"}, {"table.json", "{}"}};

std::string filled(const std::string& page) {
  return with_tables(page, [](const std::filesystem::path& file) {
    const auto found = kFiles.find(file.string());
    if (found != kFiles.end()) return found->second;
    if (file.string().ends_with(".run.json")) return std::string();
    throw std::runtime_error(file.string() + ": expected a readable file, found none");
  });
}

std::string mistake(const std::string& page) {
  try {
    filled(page);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(PageTables, AreReplacedAndTheRestOfThePageIsUnchanged) {
  const std::string begin = "# Words\n\n<!-- rows t.json: test, trials, mean_s -->\n";
  const std::string end = "<!-- end of rows -->\n\nMore words.\n";
  const std::string made = filled(begin + "something old\n" + end);
  EXPECT_EQ(
      made,
      begin + "| test | trials | mean, s |\n|---|---|---|\n| head only | 100 | 2.3 |\n| a \\| b | 100 | – |\n" + end);
  EXPECT_EQ(filled(made), made) << "a second time changes nothing";
}

TEST(PageTables, ShowRatesAndMeansWithTheirIntervals) {
  const std::string made = filled(
      "<!-- rows t.json: failed, right_mean_s, right_hours, false_flips_per_hour, flip -->\n<!-- end of rows -->\n");
  EXPECT_NE(made.find("| 2.0 % (0.6 % to 7.0 %) | 3.0 (2.5 to 4.0) | 1.23 | 0.00 to any number | 98.0 % |"),
            std::string::npos)
      << made;
}

TEST(PageTables, ShowOnlyTheRequestedRows) {
  const std::string made = filled("<!-- rows t.json: test, mode | trials | mode = default -->\n<!-- end of rows -->\n");
  EXPECT_NE(made.find("| head only | default | 100 |"), std::string::npos) << made;
  EXPECT_EQ(made.find("none"), std::string::npos) << made;
}

TEST(PageTables, ShowRowsThatHaveOneOfSeveralValues) {
  const std::string comment = "<!-- rows t.json: test | trials | mode = default, mode = none, trials = 100 -->\n";
  const std::string made = filled(comment + "<!-- end of rows -->\n");
  EXPECT_NE(made.find("| head only | 100 |\n| a \\| b | 100 |\n"), std::string::npos) << made;
  EXPECT_EQ(mistake("<!-- rows t.json: test | mode = default, trials = 20, trials = 30 -->\n<!-- end of rows -->\n"),
            "line 1: t.json: expected rows with the required values, found none");
}

TEST(PageTables, NameTheRunOfTheirResults) {
  const std::string made = filled("<!-- rows run.json: trials -->\n<!-- end of rows -->\n");
  EXPECT_NE(
      made.find("\n`reorient experiment table1`; commit abc; seeds 1 to 100; machine a computer; when 2026-11-22\n"),
      std::string::npos)
      << made;
}

TEST(PageTables, KeepTheLineEndingsOfThePage) {
  const std::string page = "Words.\r\n<!-- rows t.json: trials -->\r\nold\r\n<!-- end of rows -->\r\nNo end of this";
  EXPECT_EQ(filled(page),
            "Words.\r\n<!-- rows t.json: trials -->\r\n| trials |\r\n|---|\r\n| 100 |\r\n| 100 |\r\n"
            "<!-- end of rows -->\r\nNo end of this");
}

TEST(PageTables, DoNotChangeAFileWithoutComments) {
  for (const char* const text : {"", "no page", "a page\n\nof words\n", "RRmModel\r\n"}) {
    EXPECT_FALSE(has_tables(text)) << text;
    EXPECT_EQ(filled(text), text);
  }
  const TemporaryFolder folder;
  const std::string file = folder.write("hall.model", "learned").string();
  const ProgramRun run = run_reorient({"experiment", "tables", file});
  EXPECT_EQ(run.code, kBadInput);
  EXPECT_NE(run.err.find(file + ": expected a comment <!-- rows"), std::string::npos) << run.err;
  EXPECT_EQ(read_text(file), "learned");
}

TEST(PageTables, DoNotUseCommentsInCodeBlocks) {
  const std::string begin = "<!-- rows t.json: trials -->\n", end = "<!-- end of rows -->\n";
  const std::string table = begin + "| trials |\n|---|\n| 100 |\n| 100 |\n" + end;
  const auto joined = [](std::initializer_list<std::string_view> parts) {
    std::string text;
    for (const std::string_view part : parts) text += part;
    return text;
  };
  for (const std::string_view fence : {"```", "~~~~", "   `````"}) {
    const std::string code = joined({fence, "text\n", begin, end, "<!-- rows gone -->\n``\n", fence, "\n"});
    EXPECT_FALSE(has_tables(code)) << code;
    EXPECT_EQ(filled(code), code);
    EXPECT_EQ(filled(joined({code, begin, end})), joined({code, table}));
    EXPECT_EQ(filled(joined({begin, end, code})), joined({table, code}));
  }
  EXPECT_EQ(filled("```\n~~~\n" + begin + end + "```\n" + begin + end), "```\n~~~\n" + begin + end + "```\n" + table);
  EXPECT_EQ(filled("`` ` ``\n" + begin + end), "`` ` ``\n" + table);
  EXPECT_EQ(filled("    ```\n" + begin + end), "    ```\n" + table) << "indented too far for a fence";
}

TEST(PageTables, OfSeveralPagesAreWrittenOnlyIfAllAreValid) {
  const TemporaryFolder folder;
  const std::string end = "<!-- end of rows -->\n";
  const std::string begin = "<!-- rows t.json: trials -->\n";
  const std::string without = folder.write("a.md", "No table.\n").string();
  const std::string right = folder.write("b.md", begin + end).string();
  const std::string wrong = folder.write("c.md", "<!-- rows t.json: trails -->\n" + end).string();
  folder.write("t.json", kRows);
  const ProgramRun refused = run_reorient({"experiment", "tables", without, right, wrong});
  EXPECT_EQ(refused.code, kBadInput);
  EXPECT_NE(refused.err.find(wrong + ": line 1: "), std::string::npos) << refused.err;
  EXPECT_EQ(read_text(right), begin + end);
  const ProgramRun made = run_reorient({"experiment", "tables", without, right});
  EXPECT_EQ(made.code, kSuccess) << made.err;
  EXPECT_EQ(read_text(without), "No table.\n");
  EXPECT_EQ(read_text(right), begin + "| trials |\n|---|\n| 100 |\n| 100 |\n" + end);
}

TEST(PageTables, ReportTheLineOfAMistake) {
  const std::string end = "\n<!-- end of rows -->\n";
  EXPECT_EQ(mistake("\n<!-- rows t.json: trails -->" + end), "line 2: unknown key 'trails' (did you mean 'trials'?)");
  EXPECT_EQ(mistake("<!-- rows gone.json: trials -->" + end),
            "line 1: gone.json: expected a readable file, found none");
  EXPECT_EQ(mistake("<!-- rows bad.json: trials -->" + end),
            "line 1: bad.json: expected JSON, found invalid or truncated text");
  EXPECT_EQ(mistake("<!-- rows table.json: trials -->" + end),
            "line 1: table.json: expected a list of rows, found object");
  EXPECT_EQ(mistake("<!-- rows t.json: trials | mode = paper -->" + end),
            "line 1: t.json: expected rows with the required values, found none");
  EXPECT_EQ(mistake("<!-- rows t.json -->" + end), "line 1: expected FILE.json: COLUMNS, found 't.json'");
  EXPECT_EQ(mistake("<!-- rows t.json: trials" + end), "line 1: expected --> at the end of the line, found none");
  EXPECT_EQ(mistake("<!-- rows t.json: trials -->\n"),
            "line 1: expected <!-- end of rows --> after these rows, found none");
  EXPECT_EQ(mistake("<!-- end of rows -->\n"), "line 1: expected <!-- rows ... --> before this comment, found none");
  EXPECT_EQ(mistake("<!-- rows t.json: trials -->\n<!-- rows t.json: trials -->" + end),
            "line 2: expected <!-- end of rows --> for the rows of line 1, found other rows");
}

/// REORIENT_REGENERATE in the environment generates them again instead of comparing them.
TEST(GeneratedFiles, TheTablesOfTheEvidenceAreThoseOfTheStoredResults) {
  const std::filesystem::path committed = std::filesystem::path(kSourceFolder) / "docs/evidence";
  const TemporaryFolder folder;
  const bool regenerate = std::getenv("REORIENT_REGENERATE") != nullptr;
  if (!regenerate) std::filesystem::copy(committed, folder.path() / "evidence");
  const std::filesystem::path pages = regenerate ? committed : folder.path() / "evidence";
  std::vector<std::string> arguments{"experiment", "tables"};
  for (const auto& entry : std::filesystem::directory_iterator(pages))
    if (entry.path().extension() == ".md") arguments.push_back(entry.path().string());
  ASSERT_GT(arguments.size(), 2U) << "no pages in " << pages;
  const ProgramRun made = run_reorient(arguments);
  ASSERT_EQ(made.code, kSuccess) << made.err;
  for (std::size_t page = 2; page < arguments.size(); ++page) {
    const std::string name = std::filesystem::path(arguments[page]).filename().string();
    EXPECT_EQ(read_text(arguments[page]), read_text(committed / name))
        << "docs/evidence/" << name << " is stale; run: reorient experiment tables docs/evidence/*.md";
  }
}

}  // namespace
}  // namespace reorient

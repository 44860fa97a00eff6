// SPDX-License-Identifier: MIT
// `reorient experiment compare`: valid and invalid tables.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/random.h"
#include "tests/program/child_program.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

std::string outcome(int seed, const std::string& right_after) {
  return R"({"seed":)" + std::to_string(seed) + R"(,"disturbed":true,"failed":)" +
         (right_after == "null" ? "true" : "false") + R"(,"right_after_s":)" + right_after +
         R"(,"corrected_after_s":null,"corrected_by":"flip_pose","false_flips":0})";
}

std::string row(const std::string& choices, const std::string& outcomes) {
  return "{" + choices + R"("trials": 3, "false_flips": 1, "right_hours": 0.5, "false_flips_per_hour_low": 0.05,
    "false_flips_per_hour_high": 11.1, "outcomes": [)" +
         outcomes + "]}";
}

const std::string kDefault = R"("mode": "default", )", kPaper = R"("mode": "paper", )";
const std::string kFast = outcome(1, "2.0") + "," + outcome(2, "3.0") + "," + outcome(3, "null");
const std::string kSlow = outcome(1, "4.0") + "," + outcome(2, "5.5") + "," + outcome(3, "9.0");

class CompareTest : public ::testing::Test {
 protected:
  std::string table(const std::string& name, const std::string& text) const {
    return folder.write(name + ".json", text).string();
  }
  static ProgramRun compare(const std::vector<std::string>& words) {
    std::vector<std::string> all{"experiment", "compare"};
    all.insert(all.end(), words.begin(), words.end());
    return run_reorient(all);
  }
  static void expect_refused(const std::vector<std::string>& words, const std::string& culprit) {
    const ProgramRun refused = compare(words);
    EXPECT_EQ(refused.code, kBadInput);
    EXPECT_EQ(refused.out, "");
    EXPECT_NE(refused.err.find(culprit), std::string::npos) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }

  TemporaryFolder folder;
  std::string before = table("before", "[" + row(kDefault, kFast) + ",\n" + row(kPaper, kSlow) + "]");
};

TEST_F(CompareTest, ReadsTheFormerNamesOfOutcomes) {
  std::string former = "[" + row(kDefault, kFast) + ",\n" + row(kPaper, kSlow) + "]";
  for (std::size_t at; (at = former.find("corrected_")) != std::string::npos;) former.replace(at, 10, "mended_");
  const ProgramRun present = compare({before, before}), read = compare({table("former", former), before});
  EXPECT_EQ(read.code, present.code) << read.err;
  EXPECT_EQ(read.code, 0) << read.err;
}

TEST_F(CompareTest, LeavesOutRowsThatArePooledOverRooms) {
  const std::string pooled = R"("mode": "paper", "room": "all", )", one = R"("mode": "paper", "room": "hall", )";
  const ProgramRun run = compare({table("a", "[" + row(one, kFast) + "," + row(pooled, "") + "]"),
                                  table("b", "[" + row(one, kSlow) + "," + row(pooled, "") + "]")});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("room hall"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("room all"), std::string::npos) << run.out;
}

TEST_F(CompareTest, ReportsDifferencesInPairs) {
  const std::string after = table("after", "[" + row(kDefault, kSlow) + "]");
  const ProgramRun done = compare({before, after});
  EXPECT_EQ(done.code, kSuccess) << done.err;
  EXPECT_TRUE(done.out.starts_with("A: " + before + "\nB: " + after + "\n\n")) << done.out;
  EXPECT_NE(
      done.out.find("mode default      3    1 of 3    0 of 3        1        0  1.0000     +2.2 [+2.0, +2.5]  0.5000"
                    "  2.00 [0.05, 11.10]  2.00 [0.05, 11.10]\n"),
      std::string::npos)
      << done.out;
  EXPECT_NE(done.out.find("\nmode paper: only in A\n"), std::string::npos) << done.out;
}

TEST_F(CompareTest, ComparesChoicesOfAnAxisWithinOneTable) {
  const ProgramRun done = compare({before, "--axis", "mode", "--from", "paper", "--to", "default"});
  EXPECT_EQ(done.code, kSuccess) << done.err;
  EXPECT_TRUE(done.out.starts_with("A: mode paper\nB: mode default\n\n")) << done.out;
  EXPECT_NE(done.out.find("-2.2 [-2.5, -2.0]"), std::string::npos) << done.out;
  expect_refused({before, "--axis", "mod", "--from", "paper", "--to", "default"},
                 "--axis: unknown axis 'mod' (did you mean 'mode'?)");
  expect_refused({before, "--axis", "mode", "--from", "papr", "--to", "default"},
                 "axis 'mode': unknown choice 'papr' (did you mean 'paper'?)");
  expect_refused({before, "--axis", "light", "--from", "paper", "--to", "default"},
                 "--axis: unknown axis 'light' (expected mode)");
  expect_refused({before, "--axis", "mode", "--from", "paper", "--to", "shipped"},
                 "axis 'mode': unknown choice 'shipped' (expected default, paper)");
  expect_refused({before, "--axis", "mode", "--from", "paper", "--to", "paper"},
                 "--from and --to: expected two different choices, found 'paper' twice");
  expect_refused({before, "--axis", "mode"}, "--axis: expected together with --from, found alone");
  expect_refused({before, before, "--axis", "mode", "--from", "paper", "--to", "default"}, "expected two tables, or");
  expect_refused({before}, "expected two tables, or one with --axis");
}

TEST_F(CompareTest, ReportsTrialsWithoutAPartner) {
  const std::string after = table("after", "[" + row(kDefault, outcome(2, "3.0") + "," + outcome(7, "1.0")) + "]");
  EXPECT_NE(
      compare({before, after}).out.find("mode default: 3 trials without a trial of the same seed in the other row\n"),
      std::string::npos);
  const std::string other = table("other", "[" + row(kDefault, outcome(8, "3.0")) + "]");
  expect_refused({before, other}, "other.json: expected a trial with the same seed as one of");
  const std::string stranger = table("stranger", "[" + row(R"("light": "hard", )", kFast) + "]");
  expect_refused({before, stranger}, "stranger.json: expected a row with the same choices as one of");
}

TEST_F(CompareTest, PairsRowsInAnyOrderOfTheirAxes) {
  const std::string one = table("one", "[" + row(R"("mode": "m", "light": "l", )", kFast) + "]");
  const std::string two = table("two", "[" + row(R"("light": "l", "mode": "m", )", kFast) + "]");
  const ProgramRun done = compare({one, two});
  EXPECT_EQ(done.code, kSuccess) << done.err;
  EXPECT_NE(done.out.find("+0.0 [+0.0, +0.0]"), std::string::npos) << done.out;
}

TEST_F(CompareTest, PrintsNoIntervalOfOnePair) {
  const std::string one = table("one", "[" + row(kDefault, outcome(1, "2.0")) + "]");
  const std::string two = table("two", "[" + row(kDefault, outcome(1, "2.5")) + "]");
  const ProgramRun done = compare({one, two});
  EXPECT_EQ(done.code, kSuccess) << done.err;
  EXPECT_NE(done.out.find(" +0.5 "), std::string::npos) << done.out;
  EXPECT_EQ(done.out.find("+0.5 ["), std::string::npos) << done.out;
}

TEST_F(CompareTest, RefusesInvalidTables) {
  const std::string good = row(kDefault, kFast);
  const std::pair<std::string, std::string> kBad[] = {
      {"", "expected JSON, found invalid or truncated text"},
      {"[\n\n{\"mode\": ", "bad.json:3: expected JSON, found invalid or truncated text"},
      {"[" + good.substr(0, good.size() / 2), "expected JSON, found invalid or truncated text"},
      {"not JSON", "expected JSON, found invalid or truncated text"},
      {"\xFF\xFE[]", "expected JSON, found invalid or truncated text"},
      {"[{\"mode\": \"\xC0\xAF\"}]", "expected JSON, found invalid or truncated text"},
      {std::string(100'000, '['), "expected JSON, found invalid or truncated text"},
      {"[]", "expected a list of rows, found an empty one"},
      {"{}", "expected a list of rows, found object"},
      {"null", "expected a list of rows, found null"},
      {"[1]", "expected an object as a row, found 1"},
      {"[{}]", "expected \"trials\" in a row, found none"},
      {R"([{"trials": 2}])", "expected \"false_flips\" in a row, found none"},
      {R"([{"mode": 3, "trials": 2}])", "expected a text as choice of \"mode\" in a row, found 3"},
      {"[" + good + "," + good + "]", "expected rows with different choices, found two with the same"},
      {"[" + row(kDefault, "7") + "]", "expected an object as an outcome, found 7"},
      {"[" + row(kDefault, "{}") + "]", "expected \"seed\" in an outcome, found none"},
      {"[" + row(kDefault, R"({"seed": -1})") + "]",
       "expected a non-negative whole number as \"seed\" of an outcome, found -1"},
      {"[" + row(kDefault, R"({"seed": 1e400})") + "]", "expected numbers below 1.8e308, found a larger one"},
      {"[" + row(kDefault, R"({"seed": 1, "disturbed": 1})") + "]",
       "expected true or false as \"disturbed\" of an outcome, found 1"},
      {"[" + row(kDefault, outcome(1, "1e300")) + "]",
       "expected a non-negative number as \"right_after_s\" of an outcome, found 1e+300"},
      {"[" + row(kDefault, outcome(1, "-1")) + "]",
       "expected a non-negative number as \"right_after_s\" of an outcome, found -1"},
      {"[" + row(kDefault, outcome(1, "1") + "," + outcome(1, "2")) + "]",
       "expected different seeds in a row, found 1 twice"},
      {"[" + row(kDefault, outcome(1, "1").replace(outcome(1, "1").find("flip_pose"), 4, "slip")) + "]",
       "expected a command as \"corrected_by\" of an outcome, found \"slip_pose\""},
  };
  for (const auto& [text, why] : kBad) {
    const std::string bad = table("bad", text);
    expect_refused({before, bad}, why);
    expect_refused({bad, before}, why);
  }
  expect_refused({before, (folder.path() / "gone.json").string()},
                 "gone.json: expected a file that 'experiment --json' wrote, found none");
  expect_refused({folder.path().string(), before}, ": expected a file that 'experiment --json' wrote, found a folder");
  const std::filesystem::path sparse = folder.write("sparse.json", "[");
  std::filesystem::resize_file(sparse, std::uintmax_t{20} << 30);
  expect_refused({before, sparse.string()},
                 "sparse.json: expected a file that 'experiment --json' wrote of at most 512 MiB, found a larger one "
                 "(20480 MiB)");
  expect_refused({before, ""}, "second");
}

TEST_F(CompareTest, PrintsAnyNameOnOneLine) {
  const std::string hostile = "[" + row(R"("m\u001b\n": "\u001b[31m<b>", )", kFast) + "]";
  const ProgramRun done = compare({table("one", hostile), table("two", hostile)});
  EXPECT_EQ(done.code, kSuccess) << done.err;
  EXPECT_EQ(done.out.find('\x1B'), std::string::npos);
  EXPECT_NE(done.out.find("\nm\\x1B \\x1B[31m<b>  "), std::string::npos) << done.out;
}

TEST_F(CompareTest, SurvivesRandomChangesOfATable) {
  const std::string good = read_text(before);
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    std::string text = good;
    for (std::uint32_t changes = 1 + random.below(4); changes > 0; --changes)
      text[random.below(text.size())] = static_cast<char>(random.below(256));
    const ProgramRun done = compare({before, table("changed", text)});
    ASSERT_TRUE(done.code == kSuccess || done.code == kBadInput) << text;
    ASSERT_LE(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
  }
}

TEST_F(CompareTest, DoesNotHideAnExperimentOfThatName) {
  folder.write("compare.toml", "title = 3");
  const ProgramRun done = run_reorient({"experiment", (folder.path() / "compare.toml").string()});
  EXPECT_EQ(done.code, kBadInput);
  EXPECT_NE(done.err.find("compare.toml:1: title"), std::string::npos) << done.err;
  EXPECT_NE(run_reorient({"experiment"}).err.find("expected an experiment"), std::string::npos);
  EXPECT_NE(run_reorient({"experiment", "compare", "--help"}).out.find("--axis"), std::string::npos);
}

}  // namespace
}  // namespace reorient

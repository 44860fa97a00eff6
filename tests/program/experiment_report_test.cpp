// SPDX-License-Identifier: MIT
// `reorient experiment --report`: a page, and all trials beside it.
#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/child_program.h"
#include "tests/program/program_run.h"
#include "tests/program/short_experiment.h"
#include "tests/well_formed.h"

namespace reorient {
namespace {

/// The short experiment with names that contain special characters of browsers and shells.
std::string hostile_experiment() {
  std::string text = kShort;
  for (const auto& [plain, hostile] :
       {std::pair("\"Who is right?\"", R"("<script>alert(\"&\")</script>")"), std::pair("\"mode\"", "\"<i>\""),
        std::pair("\"default\"", "\"a&b\""), std::pair("\"none\"", R"("\"none\"")")})
    text.replace(text.find(plain), std::string_view(plain).size(), hostile);
  return text;
}

class ExperimentReport : public ShortExperiment {
 protected:
  ExperimentReport() { folder.write("short.toml", hostile_experiment()); }
  ProgramRun run(std::vector<std::string> more) const {
    more.insert(more.begin(), {"--out", path("out"), "--resume"});
    return ShortExperiment::run(more);
  }
};

TEST_F(ExperimentReport, IsAPageWithAllTrialsBesideIt) {
  const ProgramRun done = run({"--report", path("report"), "--json", path("rows.json")});
  ASSERT_EQ(done.code, kSuccess) << done.err;
  EXPECT_NE(done.out.find("report: " + path("report/index.html")), std::string::npos) << done.out;
  const std::string page = read_text(path("report/index.html"));
  EXPECT_EQ(mistake_in_markup(page), "");
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(read_text(path("report/rows.json")), read_text(path("rows.json")));

  const auto trials = nlohmann::json::parse(read_text(path("report/trials.json")));
  ASSERT_EQ(trials.size(), 4U);
  EXPECT_EQ(trials[2]["choices"]["<i>"], "\"none\"");
  EXPECT_EQ(trials[2]["task"], 3);
  const auto rows = nlohmann::json::parse(read_text(path("rows.json")));
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const auto& outcome = rows[i / 2]["outcomes"][i % 2];
    for (const char* key :
         {"seed", "disturbed", "failed", "right_after_s", "corrected_after_s", "corrected_by", "false_flips"})
      EXPECT_EQ(outcome[key], trials[i][key]) << key;
    EXPECT_EQ(trials[i]["confidences"]["time_s"].size(), trials[i]["confidences"]["correct"].size());
  }
  const std::string csv = read_text(path("report/trials.csv"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
}

TEST_F(ExperimentReport, ContainsNothingAboutTheMachineInItsRows) {
  ASSERT_EQ(run({"--report", path("report")}).code, kSuccess);
  EXPECT_NE(read_text(path("report/index.html")).find(" cores"), std::string::npos);
  for (const char* name : {"report/rows.json", "report/trials.json", "report/trials.csv"})
    EXPECT_EQ(read_text(path(name)).find("cores"), std::string::npos) << name;
}

TEST_F(ExperimentReport, ShowsTheShellCommandThatRepeatsIt) {
  ASSERT_EQ(run({"--report", path("it's here"), "--trials", "1"}).code, kSuccess);
  const std::string page = read_text(path("it's here/index.html"));
  EXPECT_NE(page.find("short.toml --trials 1 --seed 1 --out " + path("out") + " --report &#39;" + path("it")),
            std::string::npos);
}

TEST_F(ExperimentReport, WritesTheOtherOutputsIfOneCannotBeWritten) {
  std::filesystem::create_directories(path("report/trials.csv/in the way"));
  const ProgramRun done = run({"--report", path("report"), "--json", path("rows.json")});
  EXPECT_EQ(done.code, kBadInput);
  EXPECT_NE(done.err.find("reorient: cannot write '" + path("report/trials.csv")), std::string::npos) << done.err;
  EXPECT_EQ(complaints(done), 1) << done.err;
  for (const char* name : {"report/index.html", "report/trials.json", "report/rows.json", "rows.json"})
    EXPECT_TRUE(std::filesystem::is_regular_file(path(name))) << name;
}

TEST_F(ExperimentReport, RefusesAnUnusableFolderBeforeItRunsAnything) {
  folder.write("taken", "");
  const ProgramRun done = run({"--report", path("taken")});
  EXPECT_EQ(done.code, kBadInput);
  EXPECT_NE(done.err.find("--report"), std::string::npos) << done.err;
  EXPECT_FALSE(std::filesystem::exists(path("out/tasks/000001.json")));
}

}  // namespace
}  // namespace reorient

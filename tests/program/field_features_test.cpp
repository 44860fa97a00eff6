// SPDX-License-Identifier: MIT
// `reorient experiment field_features`, called as by a user.
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program/program.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

TEST(FieldFeaturesExperiment, ReportsWhatIsFoundOfEachType) {
  const TemporaryFolder folder;
  const std::string json = (folder.path() / "f.json").string();
  const auto run = [&](const std::string& seed) {
    return run_reorient({"experiment", "field_features", "--places", "3", "--width", "320", "--lights", "same",
                         "--gaze-speeds", "0", "--seed", seed, "--set", "simulator.other_robots=6", "--json", json});
  };
  const ProgramRun first = run("3");
  ASSERT_EQ(first.code, kSuccess) << first.err;
  for (const char* kind : {"line points", "goal posts", "center circle", "intersections", "marks", "ball", "obstacles"})
    EXPECT_NE(first.out.find(kind), std::string::npos) << kind << "\n" << first.out;
  const auto conditions = nlohmann::json::parse(std::ifstream(json));
  ASSERT_EQ(conditions.size(), 1u);
  EXPECT_EQ(conditions[0]["images"], 9);
  EXPECT_EQ(conditions[0]["light"], "same");
  int lines_in_view = 0, lines_found = 0;
  for (const auto& row : conditions[0]["rows"]) {
    if (row["percept"] != "line points") continue;
    lines_in_view += row["in_view"].get<int>();
    lines_found += row["found"].get<int>();
  }
  EXPECT_GT(lines_in_view, 50);
  EXPECT_GT(lines_found, 0.6 * lines_in_view);
  EXPECT_EQ(run("3").out, first.out) << "one seed, one table";
}

TEST(FieldFeaturesExperiment, RefusesUnknownNames) {
  const auto complaint = [](const std::vector<std::string>& more) {
    std::vector<std::string> words{"experiment", "field_features", "--places", "1"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramRun run = run_reorient(words);
    EXPECT_EQ(run.code, kBadInput) << run.out;
    return run.err;
  };
  EXPECT_NE(complaint({"--rooms", "nowhere.hdr"}).find("nowhere.hdr"), std::string::npos);
  EXPECT_NE(complaint({"--lights", "candle"}).find("candle"), std::string::npos);
  EXPECT_NE(complaint({"--gaze-speeds", "9"}).find("expected a number from 0 to 5, found '9'"), std::string::npos);
  EXPECT_NE(complaint({"--places", "0"}).find("--places"), std::string::npos);
  EXPECT_NE(complaint({"--set", "field_features.no_such=1"}).find("field_features.no_such"), std::string::npos);
  EXPECT_NE(complaint({"--json", "/no/such/folder/f.json"}).find("/no/such/folder"), std::string::npos);
}

}  // namespace
}  // namespace reorient

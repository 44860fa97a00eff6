// SPDX-License-Identifier: MIT
// An experiment that compares room awareness with its peers, from the command to the page.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/short_experiment.h"
#include "tests/well_formed.h"
#include "workbench/experiments/peers/compass_look.h"

namespace reorient {
namespace {

constexpr const char* kCompared = R"(title = "Who knows?"
trials = 2
[condition]
scenario = "trial"
compasses = true
width = 160
room_awareness = false
without = ["orientation", "background_training", "kidnap_recovery", "goal_search", "wall_gaze"]
parameters.trial.event = "none"
parameters.trial.learn = 12.0
parameters.trial.wait_least = 100.0
parameters.trial.wait_most = 100.0
parameters.transition_compass.palette = 2.0
measured_from = "waiting"
limit = 8.2
hold = 0
)";

class CompassExperiment : public ShortExperiment {
 protected:
  CompassExperiment() { folder.write("short.toml", kCompared); }
};

TEST_F(CompassExperiment, PrintsARowForEachMethod) {
  const ProgramRun done =
      run({"--out", path("out"), "--json", path("rows.json"), "--report", path("report"), "--jobs", "2"});
  ASSERT_EQ(done.code, kSuccess) << done.err;
  for (const std::string_view method : kCompassMethods) EXPECT_NE(done.out.find(method), std::string::npos) << done.out;
  const auto rows = nlohmann::json::parse(read_text(path("rows.json")));
  ASSERT_EQ(rows.size(), kCompassMethods.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i]["method"], kCompassMethods[i]);
    EXPECT_EQ(rows[i]["trials"], 2);
    EXPECT_EQ(rows[i]["looks"], 2);
    for (const char* key : {"auc_frame", "auc_1s", "auc_3s", "eer_frame", "eer_1s", "eer_3s", "silent_3s"}) {
      EXPECT_GE(rows[i][key], 0.0) << key;
      EXPECT_LE(rows[i][key], 1.0) << key;
    }
    EXPECT_LE(rows[i]["auc_3s_low"], rows[i]["auc_3s_high"]);
    EXPECT_EQ(rows[i]["flipped_3s"].is_null(), !kHasFlipRule[i]);
    EXPECT_EQ(rows[i]["false_flipped_3s"].is_null(), !kHasFlipRule[i]);
  }
  EXPECT_EQ(rows[0]["auc_3s"], 1.0) << "the light has not changed, so room awareness is right";
  const std::string page = read_text(path("report/index.html"));
  EXPECT_EQ(mistake_in_markup(page), "");
  EXPECT_NE(page.find("id=\"compasses\""), std::string::npos);
  EXPECT_EQ(read_text(path("report/rows.json")), read_text(path("rows.json")));
  const auto trials = nlohmann::json::parse(read_text(path("report/trials.json")));
  ASSERT_EQ(trials[0]["looks"].size(), 1U);
  EXPECT_EQ(trials[0]["looks"][0]["room awareness"]["if_right"].size(), kLookTimes.size());
  // The stored results are those that were measured, and one process measures the same.
  EXPECT_EQ(run({"--out", path("out"), "--json", path("again.json"), "--resume"}).code, kSuccess);
  EXPECT_EQ(read_text(path("again.json")), read_text(path("rows.json")));
  EXPECT_EQ(table("alone"), read_text(path("rows.json")));
}

TEST_F(CompassExperiment, AcceptsAPeersParametersAndRefusesUnknownOnes) {
  expect_refused({"--set", "tile_row_compass.colums=24"}, "tile_row_compass.columns");
  expect_refused({"--set", "horizon_compass.band=-1"}, "horizon_compass.band");
  EXPECT_EQ(run({"--out", path("out"), "--trials", "1", "--set", "tile_row_compass.columns=24"}).code, kSuccess);
}

TEST_F(CompassExperiment, LearnsTheMirroredPoseForTheGivenTime) {
  EXPECT_EQ(run({"--out", path("out"), "--json", path("rows.json"), "--set", "comparison.learn_mirrored=600"}).code,
            kSuccess);
  const auto rows = nlohmann::json::parse(read_text(path("rows.json")));
  EXPECT_EQ(rows[0]["auc_3s"], 0.0) << "to a map that was learned mirrored, the mirrored pose is the right one";
  // The last method has little evidence after so few looks, but the evidence has changed its sign.
  EXPECT_EQ(run({"--out", path("plain"), "--json", path("plain.json")}).code, kSuccess);
  const auto plain = nlohmann::json::parse(read_text(path("plain.json")));
  ASSERT_NE(plain.back()["auc_3s"], 0.5);
  EXPECT_EQ(rows.back()["auc_3s"].get<double>(), 1.0 - plain.back()["auc_3s"].get<double>());
  expect_refused({"--set", "comparison.learn_mirrored=-1"}, "comparison.learn_mirrored");
  expect_refused({"--set", "comparison.learn_miror=1"}, "comparison.learn_mirrored");
}

TEST_F(CompassExperiment, ShowsRightPosesBeforeAKidnapping) {
  std::string text = kCompared;
  text.replace(text.find("limit = 8.2"), 11, "limit = 12.2");
  folder.write("short.toml", text);
  EXPECT_EQ(run({"--out", path("out"), "--json", path("rows.json"), "--set", "comparison.mirrored_after=4"}).code,
            kSuccess);
  const auto rows = nlohmann::json::parse(read_text(path("rows.json")));
  EXPECT_EQ(rows[0]["looks"], 2);
  EXPECT_EQ(rows[0]["auc_3s"], 1.0);
  EXPECT_EQ(rows[0]["false_flipped_3s"], 0.0);
}

TEST_F(CompassExperiment, MeasuresARobotThatWasCarriedToItsMirroredPose) {
  std::string text = kCompared;
  const auto replace = [&text](const std::string& old, const std::string& with) {
    text.replace(text.find(old), old.size(), with);
  };
  replace("event = \"none\"", "event = \"mirrored_placement\"");
  replace("wait_least = 100.0", "wait_least = 0.0");
  replace("wait_most = 100.0", "wait_most = 0.0");
  replace("measured_from = \"waiting\"", "measured_from = \"measured\"");
  replace("limit = 8.2", "limit = 12.2");
  folder.write("short.toml", text);
  EXPECT_EQ(run({"--out", path("out"), "--json", path("rows.json")}).code, kSuccess);
  const auto rows = nlohmann::json::parse(read_text(path("rows.json")));
  ASSERT_FALSE(rows.empty()) << "the reflection of the belief is right, so there are looks";
  EXPECT_EQ(rows[0]["auc_3s"], 1.0);
}

TEST_F(CompassExperiment, RefusesAPeersParametersWithoutAComparison) {
  std::string text = kCompared;
  text.replace(text.find("compasses = true"), 16, "compasses = false");
  folder.write("short.toml", text);
  expect_refused({"--out", path("out"), "--trials", "1", "--set", "tile_row_compass.columns=24"},
                 "tile_row_compass.columns");
}

TEST_F(CompassExperiment, RefusesAnAxisWithTheNameOfAColumn) {
  folder.write("short.toml", std::string(kCompared) + "[[axis]]\nname = \"looks\"\n[[axis.choice]]\nname = \"a\"\n");
  expect_refused({"--out", path("out")}, "looks");
}

}  // namespace
}  // namespace reorient

// SPDX-License-Identifier: MIT
// A simulated robot with an unknown offset of its camera.
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program/model/model_file.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

constexpr double kThreeDegrees = 0.05235987755982988;

class TiltedCamera : public ::testing::Test {
 protected:
  /// A robot that walks between the marks.
  ProgramRun walk(double tilt, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"run",
                                   "patrol",
                                   "--seconds",
                                   "25",
                                   "--width",
                                   "160",
                                   "--log",
                                   "off",
                                   "--json",
                                   json,
                                   "--no-pictures",
                                   "--set",
                                   "simulator.tilt_offset=" + std::to_string(tilt)};
    words.insert(words.end(), more.begin(), more.end());
    return run_reorient(words);
  }
  nlohmann::json summary() const { return nlohmann::json::parse(std::ifstream(json)); }
  /// Where the head looks ahead, degrees.
  static double pitch_of(const nlohmann::json& summary) {
    const nlohmann::json& bias = summary.at("camera_bias_degrees");
    return bias.at("torso_pitch").get<double>() + bias.at("upper_pitch").get<double>();
  }

  TemporaryFolder folder;
  std::string json = (folder.path() / "summary.json").string();
};

TEST_F(TiltedCamera, IsEstimatedAndDoesNotDisturbThePose) {
  for (const double side : {1.0, -1.0}) {
    const ProgramRun run = walk(side * kThreeDegrees);
    const nlohmann::json told = summary();
    EXPECT_NEAR(pitch_of(told), 3.0 * side, 0.8);
    EXPECT_LT(told.at("mean_position_error_meters").get<double>(), 0.12);
    EXPECT_LT(told.at("mean_rotation_error_degrees").get<double>(), 3.0);
    EXPECT_NE(run.out.find(side > 0.0 ? "degrees lower than is measured" : "degrees higher than is measured"),
              std::string::npos)
        << run.out;
  }
}

TEST_F(TiltedCamera, WithoutATiltIsNotReported) {
  const ProgramRun run = walk(0.0);
  EXPECT_NEAR(pitch_of(summary()), 0.0, 0.8);
  EXPECT_EQ(run.out.find("than is measured"), std::string::npos) << run.out;
}

TEST_F(TiltedCamera, DisturbsThePoseOfARobotThatDoesNotEstimateIt) {
  walk(kThreeDegrees, {"--set", "pose_tracker.enabled=false"});
  EXPECT_EQ(pitch_of(summary()), 0.0);
  EXPECT_GT(summary().at("position_error_meters").get<double>(), 0.12);
}

TEST_F(TiltedCamera, IsKnownTheNextDayToTheSameBody) {
  const std::string model = (folder.path() / "hall.model").string();
  walk(kThreeDegrees, {"--model", model});
  const std::optional<KnownBias> known = read_model_file(model).camera_bias;
  ASSERT_TRUE(known);
  EXPECT_NEAR(to_degrees(known->bias.torso.pitch + known->bias.mounts[0].pitch), 3.0, 0.8);
  const ProgramRun shown = run_reorient({"model", model});
  EXPECT_NE(shown.out.find("straight ahead it looks +"), std::string::npos) << shown.out;

  // For a short time, in which nothing can be learned.
  walk(kThreeDegrees, {"--model", model, "--seconds", "0.1"});
  EXPECT_NEAR(pitch_of(summary()), 3.0, 0.8);
}

}  // namespace
}  // namespace reorient

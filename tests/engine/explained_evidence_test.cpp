// SPDX-License-Identifier: MIT
// The reasons of a belief in a record, on request: the evidence of each tile and the fit of each feature.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "robots/simulator/simulator.h"
#include "tests/engine/frame_fixture.h"

namespace reorient {
namespace {

SimulatorParameters small_images() {
  SimulatorParameters parameters;
  parameters.width = 320;
  return parameters;
}

/// A robot that looks around, and gives a command after 12 s.
std::string looking_around_until(const std::string& action) {
  return R"(behavior "tested" { initial = "waiting",
    update = function() head.look(math.sin(2 * clock.time), 0) end,
    state "waiting" { { "acting", after = 12, because = "it is time" } },
    state "acting" { enter = function() )" +
         action + R"( end } })";
}

/// Steps a robot that learns the room for 14 s. Returns the largest evidence, and checks the sum in each frame that was
/// evaluated: `after` is the factor from the evidence before the command to the evidence after it.
double most_evidence(const std::string& action, double after) {
  const Pose2 place(-2.0, 1.0, 0.5);
  Simulator simulator(small_images(), RobotBody(), FieldDimensions(), procedural_hall(1, {}), place, 1);
  FrameSetup setup;
  setup.scripts.apply({"behaviors/tested.lua", ScriptText{looking_around_until(action), ""}});
  setup.behaviors = {"tested"};
  FrameLoop engine(std::move(setup));
  FrameInputs inputs;
  inputs.external.initial_pose = InitialPose{place};
  int evaluated = 0, commands = 0;
  double most = 0.0;
  for (int i = 0; i < 14 * 30; ++i) {
    simulator.observe(inputs.observation);
    const FrameRecord& record = engine.step(inputs, {Topic::room});
    simulator.answer(record.answer);
    inputs.external = {};
    if (!record.inputs.room_camera || !record.world.evaluating) continue;
    const std::vector<double>& tiles = record.room.evidence;
    const double sum = std::accumulate(tiles.begin(), tiles.end(), 0.0);
    EXPECT_NEAR(record.world.confidence.evidence, record.reorientation ? after * sum : sum, 1e-9) << i;
    ++evaluated;
    commands += record.reorientation ? 1 : 0;
    most = std::max(most, std::abs(sum));
  }
  EXPECT_GT(evaluated, 300);
  EXPECT_EQ(commands, 1);
  return most;
}

TEST(EvidenceOfTiles, HasTheEvidenceBeforeACommandAsItsSum) {
  EXPECT_GT(most_evidence("command.flip_pose()", -1.0), 1.0);
  EXPECT_GT(most_evidence("command.reset_orientation()", 0.0), 1.0);
}

/// A robot before the center circle.
class FeatureFitsOfARun : public testing::Test {
 protected:
  FeatureFitsOfARun() {
    FrameSetup setup;
    setup.scripts.apply({"behaviors/tested.lua", ScriptText{kIdle, ""}});
    setup.behaviors = {"tested"};
    engine.emplace(std::move(setup));
  }

  const FrameRecord& step() {
    simulator.observe(inputs.observation);
    inputs.observation.belief = external;
    engine->step(inputs, {Topic::feature_fits});
    inputs.external = {};
    return engine->record();
  }

  /// Fraction of the line points that the pose filter matches in the frames after this pose was set.
  double matched_at(const Pose2& believed) {
    inputs.external.initial_pose = InitialPose{believed};
    std::size_t all = 0, matched = 0;
    for (int i = 0; i < 3; ++i) {
      const FrameRecord& record = step();
      for (std::size_t camera = 0; camera < 2; ++camera) {
        const FeatureFits& fits = record.feature_fits[camera];
        EXPECT_EQ(fits.line_points.size(), record.percepts[camera].line_points.size());
        EXPECT_EQ(fits.goal_posts.size(), record.percepts[camera].goal_posts.size());
        all += fits.line_points.size();
        for (const float fit : fits.line_points) matched += fit >= 0.0f && fit < 1.0f ? 1 : 0;
      }
    }
    EXPECT_GT(all, 30u);
    return static_cast<double>(matched) / static_cast<double>(all);
  }

  Pose2 place{-0.8, 0.0, 0.0};
  Simulator simulator{small_images(), RobotBody(), FieldDimensions(), procedural_hall(1, {}), place, 1};
  FrameInputs inputs;
  std::optional<ExternalBelief> external;
  std::optional<FrameLoop> engine;
};

TEST_F(FeatureFitsOfARun, MatchMoreFeaturesAtTheRightPoseThanBesideIt) {
  const double right = matched_at(place);
  EXPECT_GT(right, 0.9);
  EXPECT_LT(matched_at(place * Pose2(1.0, 0.5, 0.6)), right - 0.2);
}

TEST_F(FeatureFitsOfARun, AreMissingWithAnExternalLocalization) {
  external.emplace().pose = place;
  const FrameRecord& record = step();
  EXPECT_FALSE(record.percepts[0].line_points.empty());
  EXPECT_TRUE(record.feature_fits[0].line_points.empty());
}

}  // namespace
}  // namespace reorient

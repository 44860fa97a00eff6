// SPDX-License-Identifier: MIT
// The teams change sides: one frame rotates the belief, the model and the view particles with the axes.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/record/record_bytes.h"
#include "localization/reorientation.h"
#include "robots/simulator/simulator.h"
#include "tests/engine/frame_fixture.h"

namespace reorient {
namespace {

const Pose2 kStandsAt(-2.0, 1.0, 0.5);

TEST(HalfTimeFrame, RotatesTheBeliefInTheSameFrame) {
  HandFedLoop loop(kIdle);
  loop.set_pose(kStandsAt);
  loop.step(10);
  const PoseBelief before = loop.world().pose;
  loop.inputs.external.half_time = true;
  loop.step();
  expect_near(loop.world().pose.pose, reflect(before.pose), 0.02);
  EXPECT_TRUE(loop.world().sides_changed);
  EXPECT_TRUE(loop.world().pose_known);
  EXPECT_TRUE(loop.record().inputs.half_time);
  EXPECT_FALSE(loop.record().reorientation) << "a change of sides is no flip";
  loop.step();
  EXPECT_FALSE(loop.record().inputs.half_time) << "it is recorded in one frame only";
  EXPECT_TRUE(loop.world().sides_changed) << "valid until the teams change sides again";
  loop.inputs.external.half_time = true;
  loop.step();
  EXPECT_FALSE(loop.world().sides_changed);
  expect_near(loop.world().pose.pose, before.pose, 0.02);
}

TEST(HalfTimeFrame, IsAppliedOnceForAllSources) {
  HandFedLoop loop(kIdle);
  loop.set_pose(kStandsAt);
  loop.step(2);
  loop.inputs.external.half_time = loop.inputs.observation.external.half_time = true;
  loop.step();
  loop.inputs.observation.external = {};
  EXPECT_TRUE(loop.world().sides_changed);
  expect_near(loop.world().pose.pose, reflect(kStandsAt));
}

TEST(HalfTimeFrame, IsAppliedBeforeThePoseThatIsSetWithIt) {
  HandFedLoop loop(kIdle);
  loop.inputs.observation.external.initial_pose = InitialPose{kStandsAt};
  loop.inputs.external.half_time = true;
  loop.step();
  expect_near(loop.world().pose.pose, kStandsAt);
}

TEST(HalfTimeFrame, IsVisibleToScriptsFromThisFrameOn) {
  HandFedLoop loop(R"(behavior "tested" { initial = "first", state "first" {
    { "second", when = function() return game.sides_changed end, because = "the teams change sides" } },
    state "second" {} })");
  loop.step(3);
  EXPECT_EQ(loop.record().name(loop.record().machines.front().state), "first");
  loop.inputs.external.half_time = true;
  loop.step();
  EXPECT_EQ(loop.record().name(loop.record().machines.front().state), "second");
}

TEST(HalfTimeFrame, IsPartOfTheRecordAndTheDigest) {
  std::vector<std::uint64_t> digests;
  for (const bool is_told : {false, true, false}) {
    HandFedLoop loop(kIdle);
    loop.inputs.external.half_time = is_told;
    RecordDigest digest;
    digest.add(loop.step());
    digests.push_back(digest.digest().value());
    std::vector<std::byte> bytes;
    write_record(loop.record(), bytes);
    EXPECT_EQ(read_record(bytes).inputs.half_time, is_told);
    EXPECT_EQ(read_record(bytes).world.sides_changed, is_told);
  }
  EXPECT_EQ(digests[0], digests[2]);
  EXPECT_NE(digests[0], digests[1]);
}

/// A robot on the simulator that rotates and learns the room, and a second engine that continues with the same state.
class HalfTimeOnTheSimulator : public ::testing::Test {
 protected:
  static constexpr const char* kRotates = R"(behavior "tested" { update = function() walk.velocity(0, 0, 0.6) end })";

  HalfTimeOnTheSimulator()
      : simulator_(parameters(), RobotBody(), FieldDimensions(), procedural_hall(1, {}), kStandsAt, 1) {
    FrameSetup setup;
    setup.scripts.apply({"behaviors/tested.lua", ScriptText{kRotates, ""}});
    setup.behaviors.emplace_back("tested");
    engine_.emplace(std::move(setup));
  }
  static SimulatorParameters parameters() {
    SimulatorParameters parameters;
    parameters.width = 160;
    return parameters;
  }

  void learn(double seconds) {
    FrameInputs inputs;
    inputs.external.initial_pose = InitialPose{kStandsAt};
    for (int i = 0; i < static_cast<int>(30.0 * seconds); ++i) {
      simulator_.observe(inputs.observation);
      simulator_.answer(engine_->step(inputs, Topics::all()).answer);
      inputs.external = {};
    }
  }
  FrameLoop another() const {
    std::vector<std::byte> state;
    engine_->save(state);
    return FrameLoop(std::span<const std::byte>(state));
  }

  Simulator simulator_;
  std::optional<FrameLoop> engine_;
};

TEST_F(HalfTimeOnTheSimulator, DoesNotChangeTheConfidencesOfTheFirstFrame) {
  learn(14.0);
  FrameLoop turned = another();
  FrameInputs inputs;
  simulator_.observe(inputs.observation);
  const FrameRecord& before = engine_->step(inputs, Topics::all());
  inputs.external.half_time = true;
  const FrameRecord& after = turned.step(inputs, Topics::all());
  const Confidences& was = before.world.confidence;
  const Confidences& is = after.world.confidence;
  ASSERT_GT(was.coverage, 0.2);
  ASSERT_GT(was.current, 0.5);
  constexpr double kRounding = 1e-9;  // the sum over the grid's cells starts at another cell
  EXPECT_NEAR(is.current, was.current, kRounding);
  EXPECT_NEAR(is.opposite, was.opposite, kRounding);
  EXPECT_EQ(is.age, was.age);
  EXPECT_NEAR(is.goal_own, was.goal_opponent, kRounding);
  EXPECT_NEAR(is.goal_opponent, was.goal_own, kRounding);
  EXPECT_NEAR(is.evidence, was.evidence, 1e-6);
  for (const FrameRecord* record : {&before, &after}) {
    EXPECT_EQ(record->answer.room.evidence, record->world.confidence.evidence);
    EXPECT_LT(record->answer.room.evidence, -4.0) << "the room must support the believed pose";
    EXPECT_TRUE(record->answer.room.usable);
  }
  EXPECT_EQ(after.world.room_status, before.world.room_status);
  expect_near(after.world.pose.pose, reflect(before.world.pose.pose), 0.01);
  EXPECT_EQ(after.world.time_since_disturbance, before.world.time_since_disturbance);

  const Wall wall(before.room.basis.wall);
  for (int tile = 0; tile < wall.tiles(); ++tile) {
    const TileModel& one = before.room.model[static_cast<std::size_t>(tile)];
    const TileModel& other = after.room.model[static_cast<std::size_t>(wall.reflected(tile))];
    EXPECT_EQ(one.visits, other.visits);
    for (std::size_t bin = 0; bin < one.mean.size(); ++bin) EXPECT_NEAR(one.mean[bin], other.mean[bin], 1e-3);
  }
}

TEST_F(HalfTimeOnTheSimulator, RotatesOnlyTheModelIfTheLocalizationIsExternal) {
  learn(14.0);
  FrameInputs inputs;
  const auto step = [&](bool half_time) -> FrameRecord {
    simulator_.observe(inputs.observation);
    inputs.observation.external.half_time = half_time;
    const Pose2 truth = simulator_.ground_truth().pose;
    inputs.observation.belief.emplace().pose = half_time ? reflect(truth) : truth;
    return engine_->step(inputs, Topics::all());
  };
  const FrameRecord before = step(false);
  const FrameRecord after = step(true);
  expect_near(after.world.pose.pose, reflect(simulator_.ground_truth().pose), 1e-9);
  EXPECT_NEAR(after.world.confidence.current, before.world.confidence.current, 0.1)
      << "the confidences must not be exchanged";
  EXPECT_GT(after.world.confidence.age, before.world.confidence.age);
  const Wall wall(before.room.basis.wall);
  for (int tile = 0; tile < wall.tiles(); ++tile) {
    const int visits = after.room.model[static_cast<std::size_t>(wall.reflected(tile))].visits;
    const int were = before.room.model[static_cast<std::size_t>(tile)].visits;
    EXPECT_TRUE(visits == were || visits == were + 1);
  }
}

}  // namespace
}  // namespace reorient

// The main job by a robot that only turns its head: it learns the room, is carried to the reflection of its belief,
// notices, and flips. Once through the twins of LoLA and V4L2 with the guard in between, once on the plain simulator.
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/frame.h"
#include "robots/simulator/simulator.h"
#include "tests/robots/nao/twin/nao_world.h"
#include "workbench/files/script_files.h"
#include "workbench/run/run_loop.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {
namespace {

const std::filesystem::path kScripts = std::filesystem::path(REORIENT_SOURCE_DIR) / "scripts";

RobotBody body_without_legs_to_walk_with() {
  RobotBody body;
  body.gait.reset();
  body.get_up_time.reset();
  return body;
}

SimulatorParameters small() {
  SimulatorParameters parameters;
  parameters.width = 160;
  return parameters;
}

const Room& hall() {
  static const Room room = procedural_hall(1, room_shape_for(FieldDimensions{}));
  return room;
}

Pose2 beside_the_field() { return Pose2(-FieldDimensions{}.penalty_mark_x, -3.5, kPi / 2.0); }

/// What a run ends with, and what was granted on the way.
struct Flips : Observer {
  void observe(const FrameRecord& frame, const StageRecord& /*stage*/) override {
    if (frame.reorientation && frame.reorientation->reorientation == Reorientation::flip_pose) ++count;
  }
  int count = 0;
};

/// Plays the scenario; its verdict.
std::optional<ScenarioVerdict> play(RobotInstance& robot, std::uint64_t seed, Flips& flips) {
  const ScriptTexts scripts = read_scripts(kScripts);
  RecordedBehaviors behaviors;
  ScenarioHost scenario(scripts, "scenarios/turned_round.lua", {}, behaviors, seed);
  FrameSetup setup;
  setup.body = robot.body;
  setup.seed = seed;
  setup.scripts = scripts;
  for (const std::string& name : scenario.wanted_behaviors()) setup.behaviors.push_back("behaviors/" + name + ".lua");
  FrameLoop engine(std::move(setup));
  RunParts parts{robot, engine, &scenario, &behaviors, {}, {&flips}, {}, 200.0, false};
  RunLoop(std::move(parts)).run();
  return scenario.record().verdict;
}

class MainJob : public testing::TestWithParam<std::uint64_t> {};

TEST_P(MainJob, EndsRightThroughLolaAndV4l2) {
  const RobotBody body = body_without_legs_to_walk_with();
  nao::NaoWorld world(small(), body, FieldDimensions{}, hall(), beside_the_field(), GetParam());
  // It stands before the scenario begins: somebody has pressed its button.
  nao::NaoOptions options;
  options.body = body;
  options.width = 160;
  options.stands_at_once = true;
  auto nao = std::make_unique<nao::Nao>(options, world.surroundings());
  Observation observation;
  while (nao->guard().state != nao::GuardState::standing) {
    ASSERT_TRUE(nao->observe(observation));
    nao->answer({});
  }
  RobotInstance robot{std::move(nao), body, RobotInstance::Clock::real, &world.simulator(), &world.simulator()};
  Flips flips;
  const std::optional<ScenarioVerdict> verdict = play(robot, GetParam(), flips);
  ASSERT_TRUE(verdict);
  EXPECT_TRUE(verdict->succeeded) << verdict->text;
  EXPECT_GE(flips.count, 1);
  EXPECT_EQ(world.body().complaint(), "") << "a joint was told what it cannot do";
  EXPECT_EQ(world.body().falls(), 0);
}

TEST_P(MainJob, EndsRightOnThePlainSimulatorWithABodyThatCannotWalk) {
  const RobotBody body = body_without_legs_to_walk_with();
  auto simulator =
      std::make_unique<Simulator>(small(), body, FieldDimensions{}, hall(), beside_the_field(), GetParam());
  Simulator* const itself = simulator.get();
  RobotInstance robot{std::move(simulator), body, RobotInstance::Clock::simulated, itself, itself};
  Flips flips;
  const std::optional<ScenarioVerdict> verdict = play(robot, GetParam(), flips);
  ASSERT_TRUE(verdict);
  EXPECT_TRUE(verdict->succeeded) << verdict->text;
  EXPECT_GE(flips.count, 1);
}

INSTANTIATE_TEST_SUITE_P(OfTenSeeds, MainJob, testing::Range<std::uint64_t>(1, 11));

}  // namespace
}  // namespace reorient

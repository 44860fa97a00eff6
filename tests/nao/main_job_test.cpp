// SPDX-License-Identifier: MIT
// The main job of a robot that only turns its head, in simulated time: once through the guard and the simulated LoLA
// and V4L2, once directly on the simulator.
#include "tests/nao/main_job.h"

#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "tests/robots/nao/twin/nao_world.h"
#include "tests/temporary_folder.h"
#include "tests/workbench/recording/replayed.h"
#include "workbench/recording/recorder.h"

namespace reorient::main_job {
namespace {

class MainJob : public testing::TestWithParam<std::uint64_t> {};

TEST_P(MainJob, EndsRightThroughLolaAndV4l2) {
  const RobotBody body = body_without_legs_to_walk_with();
  nao::NaoWorld world(with_images_of_width(160), body, FieldDimensions{}, hall(), beside_the_field(), GetParam());
  nao::NaoOptions options;
  options.body = body;
  options.width = 160;
  options.stands_at_once = true;
  auto nao = std::make_unique<nao::Nao>(options, world.surroundings());
  ASSERT_TRUE(stand_up(*nao));
  RobotInstance robot{std::move(nao), body, RobotInstance::Clock::real, &world.simulator(), &world.simulator()};
  Flips flips;
  const TemporaryFolder folder;
  RecorderOptions recording;
  recording.file = folder.path() / "run.mcap";
  recording.most_waiting = std::size_t{512} << 20;  // ten times faster than real time, on any disk
  Recorder recorder(recording, [](const std::string& trouble) { ADD_FAILURE() << trouble; });
  const std::optional<ScenarioVerdict> verdict = play(robot, GetParam(), flips, &recorder);
  ASSERT_TRUE(verdict);
  EXPECT_TRUE(verdict->succeeded) << verdict->text;
  EXPECT_GE(flips.count, 1);
  recorder.end();
  const Replayed replayed = replay(folder.path() / "run.mcap");
  EXPECT_EQ(replayed.frames, recorder.counts().frames);
  EXPECT_EQ(replayed.different, 0u);
  EXPECT_EQ(world.body().complaint(), "") << "a joint got an invalid command";
  EXPECT_EQ(world.body().falls(), 0);
}

TEST_P(MainJob, EndsRightOnThePlainSimulatorWithABodyThatCannotWalk) {
  const RobotBody body = body_without_legs_to_walk_with();
  auto simulator = std::make_unique<Simulator>(with_images_of_width(160), body, FieldDimensions{}, hall(),
                                               beside_the_field(), GetParam());
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
}  // namespace reorient::main_job

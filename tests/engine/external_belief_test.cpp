// SPDX-License-Identifier: MIT
// A robot with its own localization: the engine's localization pauses, and answers contain the reorientations.
#include "engine/world/external_belief.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "robots/simulator/simulator.h"
#include "tests/engine/frame_fixture.h"
#include "tests/paths.h"
#include "workbench/files/script_files.h"

namespace reorient {
namespace {

const Pose2 kHere(2.0, -1.0, 0.4);

ExternalBelief sure_of(const Pose2& pose) {
  ExternalBelief belief;
  belief.pose = pose;
  belief.covariance.diagonal() << 0.01, 0.01, 0.003;
  return belief;
}

TEST(ExternalBelief, IsUsedAtOnceAndCountsAsKnownIfItIsCertain) {
  HandFedLoop loop(kIdle);
  loop.inputs.observation.belief = sure_of(kHere);
  loop.step();
  expect_near(loop.world().pose.pose, kHere);
  EXPECT_EQ(loop.world().pose.cluster_weight, 1.0);
  EXPECT_TRUE(loop.world().pose_known);
  EXPECT_TRUE(loop.record().inputs.external_belief);
  loop.inputs.observation.belief->covariance(2, 2) = 3.0;
  loop.step();
  EXPECT_FALSE(loop.world().pose_known);
}

TEST(ExternalBelief, IsTheHeaviestClusterOfItsParticles) {
  std::vector<ExternalBelief::Particle> particles;
  particles.reserve(100);
  for (int i = 0; i < 60; ++i) particles.push_back({kHere * Pose2(0.001 * i, 0.0, 0.0), 2.0});
  for (int i = 0; i < 40; ++i) particles.push_back({reflect(kHere), 1.0});
  HandFedLoop loop(kIdle);
  loop.wanted = {Topic::pose_particles};
  loop.inputs.observation.belief.emplace().particles = particles;
  loop.step();
  expect_near(loop.world().pose.pose, kHere);
  EXPECT_NEAR(loop.world().pose.cluster_weight, 0.75, 1e-6);
  EXPECT_NEAR(loop.world().pose.reflected_weight, 0.25, 1e-6);
  EXPECT_EQ(loop.record().pose_particles.particles.size(), particles.size());
}

TEST(ExternalBelief, IsIgnoredIfItIsInvalid) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ExternalBelief no_place = sure_of(kHere);
  no_place.pose.position.x() = nan;
  ExternalBelief no_spread = sure_of(kHere);
  no_spread.covariance(0, 0) = -1.0;
  const std::vector<ExternalBelief::Particle> weightless(3, {kHere, 0.0});
  const std::vector<ExternalBelief::Particle> mad{{kHere, nan}, {Pose2(nan, 0, 0), 1.0}, {kHere, -1.0}};
  ExternalBelief without_weight = sure_of(kHere);
  without_weight.particles = weightless;
  ExternalBelief without_sense = sure_of(kHere);
  without_sense.particles = mad;
  for (const ExternalBelief& bad : {no_place, no_spread, without_weight, without_sense}) {
    HandFedLoop loop(kIdle);
    loop.set_pose(Pose2(-1.0, 1.0, 0.0));
    loop.inputs.observation.belief = bad;
    loop.step();
    EXPECT_FALSE(loop.record().inputs.external_belief);
    expect_near(loop.world().pose.pose, Pose2(-1.0, 1.0, 0.0));
  }
}

TEST(ExternalBelief, GetsAReorientationInTheAnswerAndIsNotChanged) {
  HandFedLoop loop(then("command.flip_pose()"));
  loop.inputs.observation.belief = sure_of(kHere);
  const FrameRecord& record = loop.reoriented();
  EXPECT_EQ(record.answer.reorientation, Reorientation::flip_pose);
  EXPECT_EQ(record.commands.front().verdict, Verdict::granted);
  expect_near(record.reorientation->belief_before.pose, kHere);
  expect_near(record.reorientation->belief_after.pose, reflect(kHere));
  expect_near(loop.world().pose.pose, kHere);
  loop.step();
  EXPECT_FALSE(loop.record().answer.reorientation) << "a reorientation is sent once";
  loop.inputs.observation.belief = sure_of(reflect(kHere));
  loop.step();
  expect_near(loop.world().pose.pose, reflect(kHere));
}

TEST(ExternalBelief, WithTwoEqualHypothesesIsTheOppositeOneAfterAFlip) {
  const std::vector<ExternalBelief::Particle> pair{{kHere, 1.0}, {reflect(kHere), 1.0}};
  HandFedLoop loop(then("command.flip_pose()"));
  loop.inputs.observation.belief.emplace().particles = pair;
  loop.step();
  const Pose2 before = loop.world().pose.pose;
  const FrameRecord& record = loop.reoriented();
  expect_near(record.reorientation->belief_before.pose, before);
  expect_near(loop.world().pose.pose, reflect(before));
  loop.step(30);
  expect_near(loop.world().pose.pose, reflect(before));
}

TEST(ExternalBelief, WithTwoHypothesesStaysTheHeavierOneUntilTheFlipIsApplied) {
  const std::vector<ExternalBelief::Particle> before{{kHere, 2.0}, {reflect(kHere), 1.0}};
  const std::vector<ExternalBelief::Particle> after{{reflect(kHere), 2.0}, {kHere, 1.0}};
  HandFedLoop loop(then("command.flip_pose()"));
  loop.inputs.observation.belief.emplace().particles = before;
  loop.reoriented();
  loop.step(10);
  expect_near(loop.world().pose.pose, kHere);
  loop.inputs.observation.belief->particles = after;
  loop.step();
  expect_near(loop.world().pose.pose, reflect(kHere));
}

TEST(ExternalBelief, HasNoDirectionAfterAResetIsExpected) {
  HandFedLoop loop(then("command.reset_orientation()"));
  loop.inputs.observation.belief = sure_of(kHere);
  const PoseBelief& after = loop.reoriented().reorientation->belief_after;
  EXPECT_EQ(after.pose.position, kHere.position);
  EXPECT_GT(after.covariance(2, 2), 1.0);
  EXPECT_FALSE(is_known(after));
}

TEST(ExternalBelief, ContinuesWithOdometryAfterItsEnd) {
  HandFedLoop loop(kIdle);
  loop.set_pose(Pose2(-2.0, 1.0, 3.0));
  loop.inputs.observation.belief = sure_of(kHere);
  loop.step(10);
  loop.inputs.observation.belief.reset();
  loop.step(29);
  EXPECT_TRUE(loop.record().inputs.external_belief) << "the last belief is used for a second";
  EXPECT_EQ(loop.world().pose.pose.position, kHere.position);
  loop.step(2);
  EXPECT_FALSE(loop.record().inputs.external_belief);
  expect_near(loop.world().pose.pose, kHere);
}

TEST(ExternalBelief, MovesWithTheOdometryInAFrameInWhichItCannotBeRead) {
  HandFedLoop loop(kIdle);
  loop.inputs.observation.belief = sure_of(kHere);
  loop.step(10);
  const Pose2 step(0.02, 0.0, 0.01);
  loop.inputs.observation.odometry = loop.inputs.observation.odometry * step;
  loop.inputs.observation.belief->pose.position.x() = std::numeric_limits<double>::quiet_NaN();
  loop.step();
  EXPECT_TRUE(loop.record().inputs.external_belief);
  EXPECT_TRUE(loop.world().pose_known);
  expect_near(loop.world().pose.pose, kHere * step, 1e-12);
  loop.inputs.observation.belief = sure_of(kHere * step);
  loop.step();
  EXPECT_TRUE(loop.record().inputs.external_belief);
  expect_near(loop.world().pose.pose, kHere * step, 1e-12);
}

TEST(ExternalBelief, DoesNotReplaceASetPoseAfterItsEnd) {
  HandFedLoop loop(kIdle);
  loop.inputs.observation.belief = sure_of(kHere);
  loop.step(10);
  loop.inputs.observation.belief.reset();
  loop.step();
  loop.set_pose(Pose2(-2.0, 1.0, 3.0));
  loop.step();
  EXPECT_FALSE(loop.record().inputs.external_belief);
  expect_near(loop.world().pose.pose, Pose2(-2.0, 1.0, 3.0));
}

TEST(ExternalBelief, IsNotAwaitedIfItWasNeverGiven) {
  HandFedLoop loop(kIdle);
  loop.set_pose(Pose2(-2.0, 1.0, 0.5));
  loop.step();
  EXPECT_FALSE(loop.record().inputs.external_belief);
}

/// A robot with its own localization, which knows everything except the orientation: its belief is correct or the exact
/// reflection.
class OwnLocalization : public Robot {
 public:
  explicit OwnLocalization(Simulator& simulator) : simulator_(simulator) {}

  bool observe(Observation& observation) override {
    simulator_.observe(observation);
    const Pose2 truth = simulator_.ground_truth().pose;
    observation.belief = sure_of(reflected ? reflect(truth) : truth);
    return true;
  }
  void answer(const Answer& answer) override {
    simulator_.answer(answer);
    answers.push_back(answer.reorientation);
    if (answer.reorientation == Reorientation::flip_pose) reflected = !reflected;
  }

  bool reflected = false;
  std::vector<std::optional<Reorientation>> answers;

 private:
  Simulator& simulator_;
};

TEST(ExternalBelief, OfAMirroredRobotIsCorrectedByTheRobotsOwnLocalization) {
  SimulatorParameters parameters;
  parameters.width = 160;
  FrameSetup setup;
  setup.scripts = read_scripts(std::filesystem::path(kSourceFolder) / "scripts");
  setup.behaviors = {"orientation", "background_training", "head_scan", "penalty_marks"};
  Simulator simulator(parameters, RobotBody(), setup.field, procedural_hall(1, {}), Pose2(-2.0, 1.0, 0.5), 1);
  OwnLocalization robot(simulator);
  FrameLoop engine(std::move(setup));
  FrameInputs inputs;
  const auto run = [&](double seconds) {
    for (int i = 0; i < static_cast<int>(30.0 * seconds) && !engine.record().answer.reorientation; ++i) {
      robot.observe(inputs.observation);
      robot.answer(engine.step(inputs).answer);
    }
  };
  run(45.0);
  ASSERT_FALSE(engine.record().answer.reorientation) << "a correct belief was reoriented";
  EXPECT_GT(engine.record().world.confidence.current, 0.6);
  robot.reflected = true;
  run(20.0);
  EXPECT_EQ(engine.record().answer.reorientation, Reorientation::flip_pose);
  EXPECT_FALSE(robot.reflected);
}

RC_GTEST_PROP(ExternalBeliefProperty, GivesValidBeliefsForAnyInput, ()) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto number = [&] {
    const int kind = *rc::gen::inRange(0, 20);
    return kind == 0 ? nan : kind == 1 ? 1e300 : 0.01 * *rc::gen::inRange(-2000, 2000);
  };
  ExternalBeliefReader reader{FieldDimensions()};
  PoseBelief last;
  for (int i = 0; i < 10; ++i) {
    std::vector<ExternalBelief::Particle> particles;
    for (int k = *rc::gen::inRange(0, 5); k > 0; --k) {
      ExternalBelief::Particle& particle = particles.emplace_back();
      particle.pose.position = {number(), number()};
      particle.pose.rotation = number();
      particle.weight = number();
    }
    ExternalBelief belief;
    belief.particles = particles;
    belief.pose.position = {number(), number()};
    belief.pose.rotation = number();
    belief.covariance.diagonal() << number(), number(), number();
    const std::optional<PoseBelief> read = reader.read(belief, last, {});
    if (!read) continue;
    last = *read;
    RC_ASSERT(read->pose.position.allFinite() && std::isfinite(read->pose.rotation));
    RC_ASSERT(read->covariance.allFinite());
    RC_ASSERT(read->cluster_weight >= 0.0 && read->cluster_weight <= 1.0 + 1e-6);
    RC_ASSERT(read->reflected_weight >= 0.0 && read->reflected_weight <= 1.0 + 1e-6);
  }
}

}  // namespace
}  // namespace reorient

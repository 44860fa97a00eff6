// SPDX-License-Identifier: MIT
#include "perception/room/room_awareness.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/bytes.h"
#include "tests/perception/room/painted_room.h"

namespace reorient {
namespace {

using test::Exposure;
using test::PaintedRoom;
using test::ScanningRobot;

enum class Recipe { adapted, paper };

RoomParameters parameters_of(Recipe recipe) {
  return recipe == Recipe::paper ? test::paper_recipe() : RoomParameters{};
}

RoomParameters by_particles() {
  RoomParameters parameters;
  parameters.view_filter.method = ViewMethod::particles;
  return parameters;
}

/// A robot that has learned the room for 20 s from a known pose and does not train any more.
ScanningRobot trained_robot(const PaintedRoom& room, const RoomParameters& parameters, std::uint64_t seed = 1) {
  ScanningRobot robot(room, parameters, seed);
  robot.run(20.0);
  robot.train = false;
  return robot;
}

void turn_the_belief(ScanningRobot& robot) {
  robot.belief = reflect(robot.truth);
  robot.awareness.on_flip();  // the confidences restart, as after any correction
}

class EachRecipe : public testing::TestWithParam<Recipe> {};
INSTANTIATE_TEST_SUITE_P(RoomAwareness, EachRecipe, testing::Values(Recipe::adapted, Recipe::paper),
                         [](const auto& each) { return each.param == Recipe::paper ? "paper" : "adapted"; });

TEST_P(EachRecipe, ACorrectBeliefGetsHighConfidence) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    ScanningRobot robot = trained_robot(PaintedRoom::colorful(seed), parameters_of(GetParam()), seed);
    robot.awareness.on_flip();
    robot.run(8.0);
    EXPECT_GT(robot.awareness.confidences().current, 0.6) << "room " << seed;
    EXPECT_LT(robot.awareness.confidences().opposite, 0.15) << "room " << seed;
  }
}

TEST_P(EachRecipe, AReflectedBeliefGetsLowConfidenceWithinSeconds) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    ScanningRobot robot = trained_robot(PaintedRoom::colorful(seed), parameters_of(GetParam()), seed);
    turn_the_belief(robot);
    robot.run(8.0);
    EXPECT_GT(robot.awareness.confidences().opposite, 0.6) << "room " << seed;
    EXPECT_LT(robot.awareness.confidences().current, 0.15) << "room " << seed;
    EXPECT_GT(robot.awareness.confidences().evidence, 5.0) << "room " << seed;
  }
}

TEST_P(EachRecipe, AFlipOfAReflectedBeliefGivesHighConfidence) {
  ScanningRobot robot = trained_robot(PaintedRoom::colorful(5), parameters_of(GetParam()));
  turn_the_belief(robot);
  robot.run(6.0);
  robot.belief = reflect(robot.belief);
  robot.awareness.on_flip();
  robot.run(6.0);
  EXPECT_GT(robot.awareness.confidences().current, 0.6);
  EXPECT_LT(robot.awareness.confidences().evidence, -5.0);
}

TEST(RoomAwareness, DetectsAReflectedBeliefUnderAnotherLight) {
  const Exposure lights[] = {{1.35, 0, 0}, {0.74, 0, 0}, {1.0, 12, -10}, {1.2, -10, 12}};
  for (const Exposure& light : lights) {
    ScanningRobot robot = trained_robot(PaintedRoom::colorful(4), parameters_of(Recipe::adapted));
    robot.exposure = light;
    turn_the_belief(robot);
    robot.run(12.0);
    EXPECT_GT(robot.awareness.confidences().opposite, 0.6) << "gain " << light.gain << ", Cb " << light.cb_shift;
  }
}

TEST(RoomAwareness, KeepsHighConfidenceInACorrectBeliefWhenTheLightChanges) {
  const Exposure lights[] = {{1.35, 0, 0}, {0.74, 0, 0}, {1.0, 12, -10}, {1.2, -10, 12}};
  for (const Exposure& light : lights) {
    ScanningRobot robot = trained_robot(PaintedRoom::colorful(4), parameters_of(Recipe::adapted));
    robot.exposure = light;
    for (int i = 0; i < 12; ++i) {
      robot.run(1.0);
      EXPECT_LT(robot.awareness.confidences().opposite, 0.5) << "gain " << light.gain << ", Cb " << light.cb_shift;
    }
    EXPECT_GT(robot.awareness.confidences().current, 0.6) << "gain " << light.gain << ", Cb " << light.cb_shift;
  }
}

TEST(RoomAwareness, DistinguishesInformativeRoomsFromOthers) {
  const RoomParameters parameters;
  EXPECT_GT(trained_robot(PaintedRoom::colorful(2), parameters).awareness.confidences().distinctiveness, 0.3);
  EXPECT_LT(trained_robot(PaintedRoom::symmetric(2), parameters).awareness.confidences().distinctiveness, 0.15);
  EXPECT_LT(trained_robot(PaintedRoom::plain(), parameters).awareness.confidences().distinctiveness, 0.05);
}

double sum_of_tiles(const RoomAwareness& awareness) {
  std::vector<double> log_odds;
  awareness.tile_evidence(log_odds);
  return std::accumulate(log_odds.begin(), log_odds.end(), 0.0);
}

TEST_P(EachRecipe, TheEvidenceIsTheSumOverItsTilesInEachEvaluatedFrame) {
  ScanningRobot robot = trained_robot(PaintedRoom::colorful(2), parameters_of(GetParam()));
  robot.train = true;
  const auto evidence = [&] { return robot.awareness.confidences().evidence; };
  double most = 0.0;
  for (int i = 0; i < 30; ++i) {
    robot.run(0.3);
    EXPECT_NEAR(sum_of_tiles(robot.awareness), evidence(), 1e-9) << i;
    most = std::max(most, std::abs(evidence()));
    if (i == 15) turn_the_belief(robot);
    EXPECT_NEAR(sum_of_tiles(robot.awareness), evidence(), 1e-9) << i;
  }
  EXPECT_GT(most, 1.0);
}

TEST(RoomAwareness, ReportsTheEvidenceOfItsTilesAlsoWithoutAComparedModel) {
  ScanningRobot robot = trained_robot(PaintedRoom::colorful(2), {});
  robot.run(2.0);
  const double before = robot.awareness.confidences().evidence;
  robot.awareness.rotate_by_180_degrees();
  EXPECT_NEAR(sum_of_tiles(robot.awareness), before, 1e-9);
  EXPECT_EQ(sum_of_tiles(RoomAwareness()), 0.0);
}

TEST(RoomAwareness, HasNoComparedTilesOfAFrameThatIsNotEvaluated) {
  ScanningRobot robot = trained_robot(PaintedRoom::colorful(2), {});
  robot.run(0.2);
  EXPECT_FALSE(robot.awareness.scores().places().empty());
  robot.evaluate = false;
  robot.run(0.2);
  EXPECT_TRUE(robot.awareness.scores().places().empty());
}

TEST(RoomAwareness, AWhiteRoomGivesNoEvidence) {
  ScanningRobot robot = trained_robot(PaintedRoom::plain(), parameters_of(Recipe::adapted));
  turn_the_belief(robot);
  for (int i = 0; i < 20; ++i) {
    robot.run(1.0);
    EXPECT_LT(robot.awareness.confidences().opposite, 0.5);
    EXPECT_LT(robot.awareness.confidences().current, 0.5);
    EXPECT_LT(std::abs(robot.awareness.confidences().evidence), 2.0);
  }
}

TEST(RoomAwareness, CoverageGrowsWithTheKnownTiles) {
  ScanningRobot robot(PaintedRoom::colorful(1), RoomParameters{}, 1);
  EXPECT_EQ(robot.awareness.confidences().coverage, 0.0);
  robot.run(1.0);
  const double soon = robot.awareness.confidences().coverage;
  robot.run(10.0);
  EXPECT_GT(robot.awareness.confidences().coverage, soon);
  EXPECT_GT(robot.awareness.confidences().coverage, 0.5);
}

TEST(RoomAwareness, AnUntrainedRoomIsNoEvidence) {
  ScanningRobot robot(PaintedRoom::colorful(1), RoomParameters{}, 1);
  robot.train = false;
  robot.run(10.0);
  EXPECT_EQ(robot.awareness.confidences().evidence, 0.0);
  EXPECT_EQ(robot.awareness.confidences().coverage, 0.0);
  EXPECT_LT(robot.awareness.confidences().current, 0.35);
  EXPECT_LT(robot.awareness.confidences().opposite, 0.35);
}

TEST(RoomAwareness, WithoutTrainingTheModelIsUnchanged) {
  ScanningRobot robot(PaintedRoom::colorful(1), RoomParameters{}, 1);
  robot.train = false;
  robot.run(1.0);
  for (const TileModel& tile : robot.awareness.model().tiles()) EXPECT_EQ(tile.visits, 0);
  EXPECT_GT(robot.awareness.confidences().visible_tiles, 3);
}

TEST(RoomAwareness, LearnsTilesThatAreMostlyInViewAndComparesOthersToo) {
  const PaintedRoom room = PaintedRoom::colorful(9);
  ScanningRobot robot(room, RoomParameters{}, 9);
  robot.awareness.update(robot.look());
  const PerceptionParameters& limits = robot.awareness.parameters().perception;
  int compared_only = 0;
  int learned = 0;
  for (const PerceivedTile& tile : robot.awareness.perceived()) {
    const TileModel& model = robot.awareness.model()[tile.tile];
    const bool is_learned = tile.counts && tile.coverage() >= limits.min_learned_coverage;
    EXPECT_EQ(model.visits, is_learned ? 1 : 0);
    if (tile.coverage() < limits.min_learned_coverage) {
      EXPECT_EQ(model.light_visits, 0);
    }
    learned += is_learned ? 1 : 0;
    compared_only += tile.counts && !is_learned ? 1 : 0;
  }
  EXPECT_GT(learned, 0);
  EXPECT_GT(compared_only, 0);
}

TEST(RoomAwareness, WithoutEvaluationFilterAndConfidencesAreUnchanged) {
  ScanningRobot robot = trained_robot(PaintedRoom::colorful(1), by_particles());
  const Confidences before = robot.awareness.confidences();
  const double azimuth = robot.awareness.view_filter().particles()[0].azimuth;
  robot.evaluate = false;
  turn_the_belief(robot);
  robot.run(3.0);
  EXPECT_EQ(robot.awareness.confidences().raw_current, before.raw_current);
  EXPECT_EQ(robot.awareness.confidences().opposite, 0.0);
  EXPECT_EQ(robot.awareness.view_filter().particles()[0].azimuth, azimuth);
}

TEST(RoomAwareness, AdaptedConfidencesSurviveAPurgeButNotAFlip) {
  ScanningRobot robot = trained_robot(PaintedRoom::colorful(1), parameters_of(Recipe::adapted));
  const double before = robot.awareness.confidences().current;
  ASSERT_GT(before, 0.5);
  robot.awareness.on_purge();
  EXPECT_EQ(robot.awareness.confidences().current, before);
  robot.awareness.on_flip();
  EXPECT_EQ(robot.awareness.confidences().current, 0.0);
}

TEST(RoomAwareness, ThePapersConfidencesStartFromZeroAfterEachCommand) {
  ScanningRobot robot = trained_robot(PaintedRoom::colorful(1), parameters_of(Recipe::paper));
  for (void (RoomAwareness::*signal)() :
       {&RoomAwareness::on_flip, &RoomAwareness::on_purge, &RoomAwareness::on_reset}) {
    robot.run(1.0);
    ASSERT_GT(robot.awareness.confidences().current, 0.0);
    (robot.awareness.*signal)();
    EXPECT_EQ(robot.awareness.confidences().current, 0.0);
    EXPECT_EQ(robot.awareness.confidences().opposite, 0.0);
  }
}

TEST(RoomAwareness, AnotherWallResetsTheModelAndOtherChangesDoNot) {
  ScanningRobot robot = trained_robot(PaintedRoom::colorful(1), RoomParameters{});
  RoomParameters parameters = robot.awareness.parameters();
  parameters.view_filter.noise *= 2.0;
  robot.awareness.set_parameters(parameters);
  EXPECT_GT(robot.awareness.confidences().coverage, 0.5);
  parameters.wall.columns = 32;
  robot.awareness.set_parameters(parameters);
  EXPECT_EQ(robot.awareness.confidences().coverage, 0.0);
  EXPECT_EQ(robot.awareness.model().tiles().size(), 4u * 32u);
  robot.run(1.0);
  EXPECT_GT(robot.awareness.confidences().visible_tiles, 3);
}

TEST(RoomAwareness, AnotherNumberOfParticlesTakesEffectAtOnce) {
  ScanningRobot robot = trained_robot(PaintedRoom::colorful(1), by_particles());
  RoomParameters parameters = robot.awareness.parameters();
  parameters.view_filter.particles = 30;
  robot.awareness.set_parameters(parameters);
  EXPECT_EQ(robot.awareness.view_filter().particles().size(), 30u);
  robot.run(6.0);
  EXPECT_GT(robot.awareness.confidences().current, 0.5);
}

TEST(RoomAwareness, AnotherViewFilterTakesEffectAtOnce) {
  ScanningRobot robot = trained_robot(PaintedRoom::colorful(1), RoomParameters{});
  RoomParameters parameters = robot.awareness.parameters();
  for (const ViewMethod method : {ViewMethod::particles, ViewMethod::grid}) {
    parameters.view_filter.method = method;
    robot.awareness.set_parameters(parameters);
    const ViewFilter& filter = robot.awareness.view_filter();
    EXPECT_EQ(filter.grid().cells(), method == ViewMethod::grid ? 96u : 0u);
    EXPECT_EQ(filter.particles().size(), method == ViewMethod::grid ? 0u : 100u);
    EXPECT_NEAR(filter.share_near(1.0, 0.5), 0.5 / kPi, 0.02) << "the belief is uniform";
    EXPECT_GT(robot.awareness.confidences().coverage, 0.5) << "the model is unchanged";
    robot.run(6.0);
    EXPECT_GT(robot.awareness.confidences().current, 0.5);
  }
}

TEST(RoomAwareness, TheSameSeedGivesTheSameBytesAndAnotherDoesNot) {
  const auto state = [](std::uint64_t seed) {
    ScanningRobot robot(PaintedRoom::colorful(1), RoomParameters{}, 1);
    robot.awareness = RoomAwareness(RoomParameters{}, seed);
    robot.run(3.0);
    std::vector<std::byte> bytes;
    ByteWriter writer(bytes);
    writer(robot.awareness);
    return bytes;
  };
  EXPECT_EQ(state(11), state(11));
  EXPECT_NE(state(11), state(12));
}

TEST(RoomAwareness, AJumpOfTheBeliefDoesNotMoveTheParticles) {
  ScanningRobot robot = trained_robot(PaintedRoom::colorful(1), by_particles());
  RoomParameters parameters = by_particles();
  parameters.view_filter.noise = 0.0;
  parameters.view_filter.sharpness = 0.0;
  parameters.view_filter.injection = 0.0;
  robot.awareness.set_parameters(parameters);
  RoomObservation view = robot.look();
  robot.awareness.update(view);
  const double before = robot.awareness.view_filter().particles()[0].azimuth;
  view.belief = reflect(view.belief);
  view.time += 0.03;
  robot.awareness.update(view);
  EXPECT_NEAR(robot.awareness.view_filter().particles()[0].azimuth, before, 1e-9);
}

TEST(RoomAwareness, ParticlesRotateWithTheBody) {
  RoomParameters parameters = by_particles();
  parameters.view_filter.noise = 0.0;
  parameters.view_filter.injection = 0.0;
  ScanningRobot robot(PaintedRoom::colorful(1), parameters, 1);
  robot.train = false;
  robot.truth = robot.belief = Pose2(0.0, 0.0, 0.0);
  RoomObservation view = robot.look();
  view.robot_from_camera = Isometry3::Identity();
  robot.awareness.update(view);
  const double before = robot.awareness.view_filter().particles()[0].azimuth;
  view.odometry_rotation += 0.25;
  view.belief.rotation += 0.25;
  view.time += 0.03;
  robot.awareness.update(view);
  EXPECT_NEAR(angle_difference(robot.awareness.view_filter().particles()[0].azimuth, before), 0.25, 1e-9);
}

TEST(RoomAwareness, KnowsWhichGoalIsInView) {
  ScanningRobot robot = trained_robot(PaintedRoom::colorful(3), RoomParameters{});
  RoomObservation view = robot.look();
  robot.belief = robot.truth = Pose2(-1.0, 0.0, 0.0);  // toward the opponent goal
  view.robot_from_camera = test::standing_camera(0.0);
  view.belief = robot.belief;
  Random noise(1);
  const Image image = robot.room.render(view.camera, to_isometry(robot.truth) * view.robot_from_camera, {}, noise);
  view.image = image.view();
  for (int i = 0; i < 60; ++i) {
    view.time += 1.0 / 30.0;
    robot.awareness.update(view);
  }
  EXPECT_GT(robot.awareness.confidences().goal_opponent, 0.4);
  EXPECT_LT(robot.awareness.confidences().goal_own, 0.1);
}

/// Reads declarations as the engine does.
struct DeclarationReader {
  int numbers = 0;
  int choices = 0;

  template <typename Number>
  void operator()(const char* name, Number& value, double low, double high, const char*, const char*) {
    EXPECT_LE(low, value) << name;
    EXPECT_GE(high, value) << name;
    ++numbers;
  }
  void operator()(const char*, bool&, const char*) { ++choices; }
  template <typename Choice>
  void operator()(const char* name, Choice& value, std::initializer_list<const char*> names, const char*) {
    EXPECT_LT(static_cast<std::size_t>(value), names.size()) << name;
    ++choices;
  }
};

TEST(RoomAwareness, DeclaresParametersWhoseDefaultsAreWithinTheirRanges) {
  RoomParameters parameters;
  DeclarationReader reader;
  std::vector<std::string> parts;
  for_each_part(parameters, [&](const char* name, auto& part) {
    parts.emplace_back(name);
    const int before = reader.numbers + reader.choices;
    describe(part, reader);
    EXPECT_GT(reader.numbers + reader.choices, before) << name;
  });
  EXPECT_EQ(parts.size(), 11u);
  EXPECT_EQ(reader.choices, 8);
}

}  // namespace
}  // namespace reorient

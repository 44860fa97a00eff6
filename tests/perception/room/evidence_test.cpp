// SPDX-License-Identifier: MIT
#include "perception/room/evidence/evidence.h"

#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/perception/room/one_row.h"

namespace reorient {
namespace {

constexpr double kLook = 1.0 / 30.0;  // s

/// Adds a view of the columns first...first + 3 of a wall that is rotated by `turn` columns relative to the belief.
class Looking {
 public:
  void look(int first, int turn, double seconds) {
    const ViewpointScores scores = room.scores(first, turn);
    for (double time = 0.0; time < seconds - 1e-9; time += kLook)
      evidence.observe(scores.places(), room.compared, kLook, parameters);
  }

  OneRow room;
  EvidenceParameters parameters;
  Evidence evidence = [] {
    Evidence fresh;
    fresh.restart(16);
    return fresh;
  }();
};

constexpr int kReflected = 8;  // columns

TEST(Evidence, SupportsThePoseThatExplainsTheView) {
  Looking robot;
  EXPECT_EQ(robot.evidence.log_odds(), 0.0);
  robot.look(3, kReflected, 1.0);
  EXPECT_GT(robot.evidence.log_odds(), 5.0);
  Looking other;
  other.look(3, 0, 1.0);
  EXPECT_LT(other.evidence.log_odds(), -5.0);
}

TEST(Evidence, GrowsWithOtherTilesButNotWithLongerViews) {
  Looking robot;
  robot.look(0, kReflected, 1.0);
  const double once = robot.evidence.log_odds();
  robot.look(0, kReflected, 20.0);
  EXPECT_LT(robot.evidence.log_odds(), 1.1 * once);
  robot.look(4, kReflected, 1.0);
  EXPECT_GT(robot.evidence.log_odds(), 1.7 * once);
}

std::vector<double> contributions(const Looking& robot) {
  std::vector<double> log_odds{7.0};  // of an earlier frame
  robot.evidence.contributions(robot.room.compared, robot.parameters, log_odds);
  return log_odds;
}

double sum_of(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

RC_GTEST_PROP(Evidence, IsTheSumOfTheContributionsOfTheTiles, ()) {
  Looking robot;
  const int looks = *rc::gen::inRange(0, 5);
  for (int i = 0; i < looks; ++i)
    robot.look(*rc::gen::inRange(0, 16), *rc::gen::inRange(0, 16), 0.01 * *rc::gen::inRange(1, 300));
  const std::vector<double> tiles = contributions(robot);
  RC_ASSERT(tiles.size() == 16u);
  RC_ASSERT(std::abs(sum_of(tiles) - robot.evidence.log_odds()) < 1e-9);
  robot.evidence.reflect(robot.room.wall);
  const std::vector<double> reflected = contributions(robot);
  for (std::size_t i = 0; i < tiles.size(); ++i)
    RC_ASSERT(std::abs(reflected[(i + kReflected) % 16] + tiles[i]) < 1e-9);
}

TEST(Evidence, OfATileThatWasNotInViewIsZeroAndOfAMatchingTileIsForTheBelievedPose) {
  Looking robot;
  robot.look(2, 0, 1.0);
  const std::vector<double> tiles = contributions(robot);
  for (std::size_t i = 0; i < tiles.size(); ++i) EXPECT_EQ(tiles[i] < -0.5, i >= 2 && i < 6) << i;
  EXPECT_EQ(tiles[0], 0.0);
}

TEST(Evidence, IgnoresPositionsWithTwoUnknownTiles) {
  OneRow room;
  room.model.forget(16);
  room.model.train(3, OneRow::colors_of(3), {1.0, 100.0, true, 0.0});
  room.compared.clear();
  room.compared.prepare(room.model, room.wall, room.comparison);
  const ViewpointScores scores = room.scores(3, 0);
  ASSERT_EQ(scores.places().size(), 1u);
  EXPECT_EQ(scores.places()[0].tile, 3);
  EXPECT_EQ(room.scores(11, 0).places().size(), 1u);  // its reflection is known
  EXPECT_TRUE(room.scores(5, 0).places().empty());
}

/// The log-odds after a view of four tiles that were trained for `one` s, and their reflections for `other` s.
double log_odds_after(double one, double other) {
  constexpr int kSeen = 4;  // columns
  const auto trained = [&](int column) {
    if (column < kSeen) return one;
    return column >= kReflected && column < kReflected + kSeen ? other : OneRow::kTrained;
  };
  Looking robot;
  robot.room.model.forget(16);
  for (int column = 0; column < 16; ++column)
    robot.room.model.train(column, OneRow::colors_of(column), {trained(column), 100.0, true, 0.0});
  robot.room.compared.clear();
  robot.room.compared.prepare(robot.room.model, robot.room.wall, robot.room.comparison);
  robot.look(0, kReflected, 1.0);
  return robot.evidence.log_odds();
}

TEST(Evidence, IsSmallerForTilesThatWereSeenOnlyBriefly) {
  const double half = EvidenceParameters{}.half_trained;
  const double full = log_odds_after(1e6, 1e6);
  EXPECT_NEAR(log_odds_after(half, 1e6) / full, 0.5, 1e-3);
  EXPECT_NEAR(log_odds_after(1e6, half) / full, 0.5, 1e-3);
  EXPECT_NEAR(log_odds_after(half, half) / full, 0.25, 1e-3);
}

TEST(Evidence, OfOneTileIsCapped) {
  Looking robot;
  robot.parameters.cap = 0.1;
  robot.look(0, kReflected, 10.0);
  EXPECT_LE(robot.evidence.log_odds(), 4 * 0.1 * robot.parameters.gain);
}

TEST(Evidence, FadesWhileOtherTilesAreInViewAndStaysWhileNoneAre) {
  Looking robot;
  robot.look(0, kReflected, 1.0);
  const double before = robot.evidence.log_odds();
  for (int frame = 0; frame < 3000; ++frame) robot.evidence.observe({}, robot.room.compared, kLook, robot.parameters);
  EXPECT_EQ(robot.evidence.log_odds(), before);
  robot.look(4, 0, 60.0);
  Looking only_the_others;
  only_the_others.look(4, 0, 60.0);
  EXPECT_NEAR(robot.evidence.log_odds(), only_the_others.evidence.log_odds(), 0.01);
}

TEST(Evidence, FollowsAChangeOfTheSameTilesWithinSeconds) {
  Looking robot;
  robot.look(0, 0, 300.0);
  robot.look(0, kReflected, 3.0);
  EXPECT_GT(robot.evidence.log_odds(), 2.0);
}

TEST(Evidence, OfASymmetricWallIsZero) {
  Looking robot;
  robot.room.model.forget(16);
  for (int column = 0; column < 16; ++column)
    robot.room.model.train(column, OneRow::colors_of(column % 8), {1.0, 100.0, true, 0.0});
  robot.room.compared.clear();
  robot.room.compared.prepare(robot.room.model, robot.room.wall, robot.room.comparison);
  for (int first = 0; first < 16; first += 4) robot.look(first, 3, 5.0);
  EXPECT_EQ(robot.evidence.log_odds(), 0.0);
  EXPECT_EQ(robot.room.compared.distinctiveness(), 0.0);
}

/// Ten of sixteen columns are known: two pairs with their reflections, and six for only one of the poses.
struct HalfKnown : Looking {
  HalfKnown() {
    room.model.forget(16);
    for (int column = 0; column < 10; ++column)
      room.model.train(column, OneRow::colors_of(column), {1.0, 100.0, true, 0.0});
    room.compared.clear();
    room.compared.prepare(room.model, room.wall, room.comparison);
  }
};

TEST(Evidence, HasLessWeightForTilesThatAreKnownForOnePoseOnly) {
  Looking robot;
  HalfKnown half;
  robot.look(2, 0, 1.0);
  half.look(2, 0, 1.0);
  EXPECT_LT(half.evidence.log_odds(), 0.0);
  EXPECT_GT(half.evidence.log_odds(), 0.5 * robot.evidence.log_odds());
}

TEST(Evidence, OpposesAPoseThatDoesNotFitWithoutKnowledgeOfTheOther) {
  HalfKnown half;
  half.look(2, kReflected, 1.0);
  EXPECT_GT(half.evidence.log_odds(), 0.0);
}

TEST(Evidence, OfOnePoseOnlyIsZeroInARoomThatMayBeSymmetric) {
  HalfKnown half;
  half.room.model.forget(16);
  for (int column = 0; column < 8; ++column)
    half.room.model.train(column, OneRow::colors_of(column), {1.0, 100.0, true, 0.0});
  half.room.compared.clear();
  half.room.compared.prepare(half.room.model, half.room.wall, half.room.comparison);
  half.look(2, kReflected, 1.0);
  EXPECT_EQ(half.evidence.log_odds(), 0.0);
}

RC_GTEST_PROP(Evidence, SupportsTheOtherPoseAfterAFlip, ()) {
  Looking robot;
  robot.look(*rc::gen::inRange(0, 16), *rc::gen::inRange(0, 16), 0.01 * *rc::gen::inRange(1, 500));
  const double before = robot.evidence.log_odds();
  robot.evidence.reflect(robot.room.wall);
  RC_ASSERT(robot.evidence.log_odds() == -before);
  robot.evidence.reflect(robot.room.wall);
  RC_ASSERT(robot.evidence.log_odds() == before);
}

RC_GTEST_PROP(Evidence, ContinuesAfterAFlipAsIfTheBeliefHadAlwaysBeenThePresentOne, ()) {
  const int first = *rc::gen::inRange(0, 16);
  const int turn = *rc::gen::inRange(0, 16);
  Looking robot, other;
  robot.look(first, turn, 1.0);
  robot.evidence.reflect(robot.room.wall);
  other.look((first + kReflected) % 16, (turn + kReflected) % 16, 1.0);
  robot.look(5, 3, 0.5);
  other.look(5, 3, 0.5);
  RC_ASSERT(std::abs(robot.evidence.log_odds() - other.evidence.log_odds()) < 1e-6);
}

}  // namespace
}  // namespace reorient

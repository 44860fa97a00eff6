// SPDX-License-Identifier: MIT
#include "perception/room/view/view_grid.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/angle.h"
#include "geometry/random.h"
#include "tests/perception/room/one_row.h"

namespace reorient {
namespace {

double whole(const ViewGrid& grid) {
  double sum = 0.0;
  for (std::size_t i = 0; i < grid.cells(); ++i) sum += grid.cell(i).share;
  return sum;
}

/// The whole belief in one or two cells around `center`.
ViewGrid sure_of(double center, int cells, const OneRow& room) {
  ViewGrid grid;
  grid.spread(cells);
  ViewFilterParameters sharp;
  sharp.sharpness = 5000.0;
  sharp.leak = 1000.0;
  for (int i = 0; i < 200; ++i) grid.correct(room.scores(0, 0), center, 1.0 / 30.0, sharp);
  return grid;
}

RC_GTEST_PROP(ViewGrid, KeepsTheSumOfTheBelief, (std::uint64_t seed)) {
  const OneRow room;
  const auto number = [](double low, double high) { return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0; };
  ViewGrid grid;
  grid.spread(*rc::gen::inRange(8, 361));
  ViewFilterParameters parameters;
  parameters.noise = number(0.0, 2.0);
  parameters.sharpness = *rc::gen::element(0.0, 150.0, 5000.0, 1e12);
  parameters.leak = number(0.1, 1000.0);
  Random random(seed);
  for (int i = 0; i < 10; ++i) {
    grid.predict(random.uniform(-3.0, 3.0), 0.2, parameters);
    grid.correct(room.scores(static_cast<int>(random.below(16)), static_cast<int>(random.below(16))),
                 random.uniform(-3.0, 3.0), 0.2, parameters);
    RC_ASSERT(std::abs(whole(grid) - 1.0) < 1e-9);
    for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
      RC_ASSERT(grid.cell(cell).share >= 0.0);
      RC_ASSERT(grid.cell(cell).azimuth > -kPi && grid.cell(cell).azimuth <= kPi);
    }
  }
}

RC_GTEST_PROP(ViewGrid, HasTheFractionOfAnArcAsTheSumOfItsTwoParts, ()) {
  const OneRow room;
  const int cells = *rc::gen::inRange(8, 200);
  const ViewGrid grid = sure_of(*rc::gen::inRange(-300, 301) / 100.0, cells, room);
  const double middle = *rc::gen::inRange(-300, 301) / 100.0;
  const double half = *rc::gen::inRange(1, 150) / 100.0;
  const double cut = middle + half * *rc::gen::inRange(-99, 100) / 100.0;
  const double begin = middle - half, end = middle + half;
  const double parts =
      grid.share_near(0.5 * (begin + cut), 0.5 * (cut - begin)) + grid.share_near(0.5 * (cut + end), 0.5 * (end - cut));
  RC_ASSERT(std::abs(grid.share_near(middle, half) - parts) < 1e-9);
  RC_ASSERT(std::abs(grid.share_near(middle, half) + grid.share_near(middle + kPi, kPi - half) - 1.0) < 1e-9);
}

RC_GTEST_PROP(ViewGrid, SpreadsByItsNoiseIndependentOfTheSteps, ()) {
  const OneRow room;
  ViewGrid grid = sure_of(1.0, 96, room);
  std::vector<ViewCluster> before, after;
  grid.find_clusters(before);
  ViewFilterParameters parameters;
  parameters.noise = 0.166;
  const int steps = *rc::gen::inRange(1, 31);
  for (int i = 0; i < steps; ++i) grid.predict(0.1, 1.0 / steps, parameters);
  grid.find_clusters(after);
  RC_ASSERT(before.size() == 1u && after.size() == 1u);
  // Variances add up. Cells outside of the cluster are not counted.
  const double spread = std::sqrt(0.166 * 0.166 + before[0].spread * before[0].spread);
  RC_ASSERT(after[0].spread > 0.8 * spread && after[0].spread < 1.01 * spread);
  RC_ASSERT(std::abs(angle_difference(after[0].azimuth, before[0].azimuth + 0.1 * steps)) < 0.02);
}

TEST(ViewGrid, IsNotBlurredByRotations) {
  const OneRow room;
  ViewGrid grid = sure_of(1.0, 96, room);
  ViewFilterParameters still;
  still.noise = 0.0;
  std::vector<ViewCell> before;
  for (std::size_t i = 0; i < grid.cells(); ++i) before.push_back(grid.cell(i));
  for (int i = 0; i < 300; ++i) grid.predict(i % 2 == 0 ? 0.0123 : -0.0123, 1.0 / 30.0, still);
  for (std::size_t i = 0; i < grid.cells(); ++i) {
    EXPECT_EQ(grid.cell(i).share, before[i].share);
    EXPECT_NEAR(angle_difference(grid.cell(i).azimuth, before[i].azimuth), 0.0, 1e-12);
  }
}

TEST(ViewGrid, NeverExcludesAPositionForever) {
  const OneRow room;
  const ViewpointScores believed = room.scores(0, 0), opposite = room.scores(0, 8);
  ViewGrid grid;
  grid.spread(96);
  const auto look = [&](const ViewpointScores& scores, int frames) {
    for (int i = 0; i < frames; ++i) {
      grid.predict(0.0, 1.0 / 30.0, {});
      grid.correct(scores, 0.0, 1.0 / 30.0, {});
    }
  };
  look(believed, 3600 * 30);  // an hour
  EXPECT_GT(grid.share_near(0.0, 0.5), 0.95);
  look(opposite, 60);
  EXPECT_GT(grid.share_near(kPi, 0.5), 0.95);
}

TEST(ViewGrid, HasAClusterForEachPeakAndNoneInAUniformBelief) {
  const OneRow room;
  const ViewpointScores believed = room.scores(0, 0), opposite = room.scores(0, 8);
  ViewGrid grid;
  grid.spread(96);
  std::vector<ViewCluster> clusters;
  grid.find_clusters(clusters);
  EXPECT_TRUE(clusters.empty());
  ViewFilterParameters blunt;
  blunt.sharpness = 50.0;
  for (int i = 0; i < 200; ++i) {  // two directions with the same score
    grid.correct(i % 2 == 0 ? believed : opposite, 0.0, 1.0 / 30.0, blunt);
    grid.predict(0.0, 1.0 / 30.0, blunt);
  }
  grid.find_clusters(clusters);
  ASSERT_EQ(clusters.size(), 2u);
  EXPECT_NEAR(std::abs(angle_difference(clusters[0].azimuth, clusters[1].azimuth)), kPi, 0.1);
  EXPECT_NEAR(clusters[0].share + clusters[1].share, 1.0, 0.2);
}

}  // namespace
}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "perception/room/view/view_filter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/bytes.h"
#include "perception/room/view/confidences.h"
#include "tests/perception/room/one_row.h"

namespace reorient {
namespace {

std::vector<std::byte> bytes_of(const ViewFilter& filter) {
  std::vector<std::byte> bytes;
  ByteWriter writer(bytes);
  writer(filter);
  return bytes;
}

RC_GTEST_PROP(ViewpointScores, TheBestCellIsTheTurnBetweenBeliefAndTruth, ()) {
  const OneRow room;
  const int turn = *rc::gen::inRange(0, 16);
  const ViewpointScores scores = room.scores(*rc::gen::inRange(0, 16), turn);
  RC_ASSERT(scores.best() == turn);
  RC_ASSERT(scores.evidence());
  RC_ASSERT(scores.least() < 1e-3);
  RC_ASSERT(std::abs(scores.distance(turn + 0.5) - 0.5 * (scores.at(turn).distance + scores.at(turn + 1).distance)) <
            1e-9);
  RC_ASSERT(std::abs(scores.distance(turn - 16.0) - scores.at(turn).distance) < 1e-9);
}

TEST(ViewpointScores, AnUnknownViewIsNoEvidence) {
  OneRow room;
  room.model.forget(16);
  for (int column = 0; column < 6; ++column) room.model.train(column, OneRow::colors_of(column), {1.0, 9.0, true, 0.0});
  room.compared.prepare(room.model, room.wall, room.comparison);
  const ViewpointScores scores = room.scores(1, 0);
  EXPECT_TRUE(scores.at(0).known);
  EXPECT_FALSE(scores.at(8).known);
  EXPECT_FALSE(scores.evidence());
  EXPECT_NEAR(room.compared.coverage(), 6.0 / 16.0, 1e-9);
}

RC_GTEST_PROP(ViewpointScores, AViewBesideItsTileIsFoundWithinTheTolerance, ()) {
  const OneRow room;
  const int first = *rc::gen::inRange(0, 16), aside = *rc::gen::inRange(-1, 2), tolerance = *rc::gen::inRange(0, 3);
  for (const bool reflected : {false, true}) {
    const ViewpointScores scores = room.scores(first, 16 + aside + (reflected ? 8 : 0), tolerance);
    RC_ASSERT(scores.places().size() == 4u);
    for (const ComparedPlace& place : scores.places()) {
      const double right = reflected ? place.as_reflected : place.as_believed;
      RC_ASSERT((right < 1e-3) == (std::abs(aside) <= tolerance));
    }
  }
}

TEST(ViewpointScores, TilesOfAViewAreMatchedTogether) {
  const OneRow room;
  std::vector<PerceivedTile> perceived;
  for (const auto& [tile, shown] : {std::pair{3, 2}, {4, 5}}) {
    PerceivedTile& seen = perceived.emplace_back();
    seen.tile = tile;
    seen.counts = true;
    seen.histogram = seen.reflected_histogram = OneRow::colors_of(shown);
  }
  ViewpointScores scores;
  scores.compute(perceived, room.compared, room.wall, room.comparison, 2);
  ASSERT_EQ(scores.places().size(), 2u);
  EXPECT_GT(scores.places()[0].as_believed + scores.places()[1].as_believed, 0.1);
}

constexpr double kFrame = 1.0 / 30.0;  // s

class ViewFilterBy : public ::testing::TestWithParam<ViewMethod> {
 protected:
  ViewFilterBy() {
    parameters.method = GetParam();
    filter.spread(parameters);
  }
  /// The camera looks `turn` columns farther to the left than in the belief, at `center`.
  void look(int turn, double center, int frames) {
    for (int i = 0; i < frames; ++i) {
      filter.predict(0.0, kFrame, parameters);
      filter.correct(room.scores(0, turn), center, kFrame, parameters);
    }
  }

  const OneRow room;
  ViewFilterParameters parameters;
  ViewFilter filter{1};
};

TEST_P(ViewFilterBy, StartsWithAUniformBelief) {
  for (double azimuth = -3.0; azimuth < 3.0; azimuth += 0.5)
    EXPECT_NEAR(filter.share_near(azimuth, from_degrees(30.0)), 1.0 / 6.0, 0.02);
  EXPECT_NEAR(filter.share_near(1.0, kPi), 1.0, 1e-9);
  EXPECT_TRUE(filter.is_made_for(parameters));
}

TEST_P(ViewFilterBy, FindsTheRotationAndForgetsTheRest) {
  const double center = 0.4, truth = center + 6 * 2 * kPi / 16;
  look(6, center, 60);
  EXPECT_GT(filter.share_near(truth, from_degrees(20.0)), 0.8);
  filter.find_clusters();
  ASSERT_FALSE(filter.clusters().empty());
  EXPECT_NEAR(angle_difference(filter.clusters()[0].azimuth, truth), 0.0, 0.1);
  EXPECT_LT(filter.clusters()[0].spread, 0.3);
  EXPECT_GT(filter.clusters()[0].share, 0.8);
}

TEST_P(ViewFilterBy, FindsTheRotationFromAWrongBelief) {
  look(0, 0.0, 60);
  ASSERT_GT(filter.share_near(0.0, 0.5), 0.9);
  look(8, 0.0, 60);
  EXPECT_GT(filter.share_near(kPi, 0.5), 0.9);
}

TEST_P(ViewFilterBy, FollowsTheCameraAroundTheCircle) {
  look(0, 3.0, 60);
  const double before = filter.share_near(3.0, 0.5);
  ViewFilterParameters still = parameters;
  still.noise = 0.0;
  for (int i = 0; i < 100; ++i) filter.predict(0.0371, kFrame, still);
  EXPECT_NEAR(filter.share_near(3.0 + 3.71, 0.5), before, 1e-9);
}

TEST_P(ViewFilterBy, IsUnchangedByAViewWithoutEvidence) {
  look(0, 0.0, 60);
  const double before = filter.share_near(0.0, 0.5);
  OneRow unknown;
  unknown.model.forget(16);
  unknown.compared.prepare(unknown.model, unknown.wall, unknown.comparison);
  for (int i = 0; i < 60; ++i) filter.correct(unknown.scores(0, 8), 0.0, kFrame, parameters);
  EXPECT_EQ(filter.share_near(0.0, 0.5), before);
}

TEST_P(ViewFilterBy, HasAClusterThatIsNotCutAtTheBackOfTheCircle) {
  look(8, 0.0, 60);
  filter.find_clusters();
  double share = 0.0;
  for (const ViewCluster& cluster : filter.clusters()) share += cluster.share;
  EXPECT_LE(share, 1.0 + 1e-9);
  ASSERT_FALSE(filter.clusters().empty());
  EXPECT_GT(filter.clusters()[0].share, 0.8);
  EXPECT_NEAR(std::abs(filter.clusters()[0].azimuth), kPi, 0.2);
}

TEST_P(ViewFilterBy, RestartsWithAnotherMethodOrSize) {
  look(0, 0.0, 60);
  ViewFilterParameters others = parameters;
  others.particles = 30;
  others.cells = 24;
  EXPECT_FALSE(filter.is_made_for(others));
  filter.spread(others);
  EXPECT_TRUE(filter.is_made_for(others));
  EXPECT_NEAR(filter.share_near(0.0, 0.5), 0.5 / kPi, 0.05);
  EXPECT_TRUE(filter.clusters().empty());
  others.method = parameters.method == ViewMethod::grid ? ViewMethod::particles : ViewMethod::grid;
  EXPECT_FALSE(filter.is_made_for(others));
}

TEST_P(ViewFilterBy, RotatedTwiceBy180DegreesHasTheSameBits) {
  look(3, 0.7, 20);
  filter.find_clusters();
  const std::vector<std::byte> before = bytes_of(filter);
  const double near = filter.share_near(0.7, 0.5);
  filter.rotate_by_180_degrees();
  EXPECT_NE(bytes_of(filter), before);
  EXPECT_NEAR(filter.share_near(0.7 + kPi, 0.5), near, 1e-9);
  filter.rotate_by_180_degrees();
  EXPECT_EQ(bytes_of(filter), before);
}

TEST_P(ViewFilterBy, ContinuesExactlyFromItsSavedState) {
  look(3, 0.7, 20);
  const std::vector<std::byte> bytes = bytes_of(filter);
  ViewFilter other(99);
  other.spread(parameters);
  ByteReader reader(bytes);
  reader(other);
  reader.finish();
  look(3, 0.7, 20);
  const std::vector<std::byte> expected = bytes_of(filter);
  std::swap(filter, other);
  look(3, 0.7, 20);
  EXPECT_EQ(bytes_of(filter), expected);
}

TEST_P(ViewFilterBy, RefusesBytesOfAnotherMethodOrSizeAndDamagedBytes) {
  look(3, 0.7, 20);
  filter.find_clusters();
  const std::vector<std::byte> bytes = bytes_of(filter);
  const auto refuses = [](const std::vector<std::byte>& what, const ViewFilterParameters& made_for) {
    ViewFilter reading(5);
    reading.spread(made_for);
    ByteReader reader(what);
    try {
      reader(reading);
    } catch (const BadBytes&) {
      return true;
    }
    return false;
  };
  EXPECT_FALSE(refuses(bytes, parameters));
  ViewFilterParameters others = parameters;
  others.particles = others.cells = 50;
  EXPECT_TRUE(refuses(bytes, others));
  others = parameters;
  others.method = parameters.method == ViewMethod::grid ? ViewMethod::particles : ViewMethod::grid;
  EXPECT_TRUE(refuses(bytes, others));
  for (std::size_t size = 0; size < bytes.size(); size += 7)
    EXPECT_TRUE(refuses({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)}, parameters)) << size;
  std::vector<std::byte> spoiled = bytes;
  std::fill(spoiled.end() - 8, spoiled.end(), std::byte{0xFF});  // the fraction of the last cluster: NaN
  EXPECT_TRUE(refuses(spoiled, parameters));
}

INSTANTIATE_TEST_SUITE_P(Method, ViewFilterBy, ::testing::Values(ViewMethod::particles, ViewMethod::grid),
                         [](const auto& one) { return one.param == ViewMethod::grid ? "Grid" : "Particles"; });

RC_GTEST_PROP(ViewParticles, HaveFiniteWeightsAndNormalizedAzimuths, (std::uint64_t seed)) {
  const OneRow room;
  ViewParticles filter(seed);
  filter.spread(50);
  const double sharpness = *rc::gen::element(0.0, 150.0, 1e9);
  for (int i = 0; i < 5; ++i) {
    filter.predict(2.5, 0.1, {});
    ViewFilterParameters parameters;
    parameters.sharpness = sharpness;
    parameters.injection = 0.0;
    filter.correct(room.scores(2, 5), -3.0, 0.1, parameters);
  }
  for (const ViewParticle& particle : filter.particles()) {
    RC_ASSERT(particle.azimuth > -kPi - 1e-12 && particle.azimuth <= kPi);
    RC_ASSERT(std::isfinite(particle.weight));
  }
}

TEST(ViewParticles, AreAllInClusters) {
  const OneRow room;
  ViewParticles filter(4);
  filter.spread(100);
  for (int i = 0; i < 60; ++i) {
    filter.predict(0.0, kFrame, {});
    filter.correct(room.scores(0, 8), 0.0, kFrame, {});
  }
  std::vector<ViewCluster> clusters;
  filter.find_clusters(clusters);
  double share = 0.0;
  for (const ViewCluster& cluster : clusters) share += cluster.share;
  EXPECT_NEAR(share, 1.0, 1e-9);
}

TEST(Confidences, AreSmoothedWithTheTimeConstantLongAfterARestart) {
  const ConfidenceParameters parameters;
  constexpr double kOld = 1000.0;
  EXPECT_NEAR(smoothing_share(parameters, 3.0, kOld), 1.0 - std::exp(-1.0), 1e-12);
  // Two half steps smooth as much as one whole step.
  const double half = smoothing_share(parameters, 0.05, kOld);
  EXPECT_NEAR((1 - half) * (1 - half), 1 - smoothing_share(parameters, 0.1, kOld), 1e-12);
  EXPECT_EQ(smoothing_share({.time_constant = 0.0}, 0.1, kOld), 1.0);
}

TEST(Confidences, AreTheMeanSinceTheRestart) {
  constexpr double kStep = 0.1;
  Confidences confidences;
  const double raw[] = {0.9, 0.5, 0.7};
  for (const double now : raw) {
    confidences.raw_current = now;
    confidences.age += kStep;
    smooth(confidences, smoothing_share({}, kStep, confidences.age));
  }
  EXPECT_NEAR(confidences.current, (0.9 + 0.5 + 0.7) / 3.0, 0.01) << "later values have slightly more weight";
}

TEST(Confidences, GrowFromZeroIfTheParametersRequireIt) {
  ConfidenceParameters paper;
  paper.true_mean_start = false;
  EXPECT_EQ(smoothing_share(paper, 0.1, 0.1), smoothing_share(paper, 0.1, 1000.0));
}

TEST(Confidences, AreTheWeightAroundBothViewCentersAndBehindTheGoals) {
  ViewFilter filter(1);
  filter.spread({.particles = 3600});
  Confidences confidences;
  take_shares(confidences, filter, 1.0, {});
  EXPECT_NEAR(confidences.raw_current, 60.0 / 360.0, 2e-3);
  EXPECT_NEAR(confidences.raw_opposite, 60.0 / 360.0, 2e-3);
  EXPECT_NEAR(confidences.goal_opponent, 25.0 / 360.0, 2e-3);
  EXPECT_NEAR(confidences.goal_own, 25.0 / 360.0, 2e-3);
  EXPECT_EQ(confidences.current, 0.0);
  smooth(confidences, 1.0);
  EXPECT_EQ(confidences.current, confidences.raw_current);
}

}  // namespace
}  // namespace reorient

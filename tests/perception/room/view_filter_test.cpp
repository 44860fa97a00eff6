#include "perception/room/view/view_filter.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "perception/room/view/confidences.h"
#include "tests/perception/room/one_row.h"

namespace reorient {
namespace {

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

TEST(ViewpointScores, AViewThatPredictsNothingIsNoEvidence) {
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

TEST(ViewFilter, SpreadsItsParticlesEvenly) {
  ViewFilter filter(1);
  filter.spread(360);
  for (double azimuth = -3.0; azimuth < 3.0; azimuth += 0.5) {
    EXPECT_NEAR(filter.share_near(azimuth, from_degrees(30.0)), 1.0 / 6.0, 0.01);
  }
}

TEST(ViewFilter, FindsTheTurnAndForgetsTheRest) {
  const OneRow room;
  ViewFilter filter(1);
  filter.spread(100);
  const double center = 0.4;
  for (int i = 0; i < 60; ++i) {
    filter.predict(0.0, 1.0 / 30.0, {});
    filter.correct(room.scores(0, 6), center, 1.0 / 30.0, {});
  }
  EXPECT_GT(filter.share_near(center + 6 * 2 * kPi / 16, from_degrees(20.0)), 0.8);
  EXPECT_EQ(filter.particles().size(), 100u);
  filter.find_clusters();
  ASSERT_FALSE(filter.clusters().empty());
  EXPECT_NEAR(angle_difference(filter.clusters()[0].azimuth, center + 6 * 2 * kPi / 16), 0.0, 0.1);
  EXPECT_LT(filter.clusters()[0].spread, 0.3);
}

TEST(ViewFilter, FindsTheTurnFromAWrongClusterByInjection) {
  const OneRow room;
  ViewFilter filter(1);
  filter.spread(100);
  for (int i = 0; i < 60; ++i) filter.correct(room.scores(0, 0), 0.0, 1.0 / 30.0, {});
  ASSERT_GT(filter.share_near(0.0, 0.5), 0.9);
  for (int i = 0; i < 60; ++i) filter.correct(room.scores(0, 8), 0.0, 1.0 / 30.0, {});
  EXPECT_GT(filter.share_near(kPi, 0.5), 0.9);
}

RC_GTEST_PROP(ViewFilter, WeightsSumUpToOneAndAzimuthsStayNormalized, (std::uint64_t seed)) {
  const OneRow room;
  ViewFilter filter(seed);
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

TEST(ViewFilter, ClustersCoverAllParticlesAndAreNotCutAtTheBackOfTheCircle) {
  const OneRow room;
  ViewFilter filter(4);
  filter.spread(100);
  for (int i = 0; i < 60; ++i) {
    filter.predict(0.0, 1.0 / 30.0, {});
    filter.correct(room.scores(0, 8), 0.0, 1.0 / 30.0, {});
  }
  filter.find_clusters();
  double share = 0.0;
  for (const ViewCluster& cluster : filter.clusters()) share += cluster.share;
  EXPECT_NEAR(share, 1.0, 1e-9);
  EXPECT_GT(filter.clusters()[0].share, 0.8);
  EXPECT_NEAR(std::abs(filter.clusters()[0].azimuth), kPi, 0.2);
}

TEST(Confidences, SmoothByATimeConstantOnceTheyAreOld) {
  const ConfidenceParameters parameters;
  constexpr double kOld = 1000.0;
  EXPECT_NEAR(smoothing_share(parameters, 3.0, kOld), 1.0 - std::exp(-1.0), 1e-12);
  // Two halves of a step smooth as much as the whole step does.
  const double half = smoothing_share(parameters, 0.05, kOld);
  EXPECT_NEAR((1 - half) * (1 - half), 1 - smoothing_share(parameters, 0.1, kOld), 1e-12);
  EXPECT_EQ(smoothing_share({.time_constant = 0.0}, 0.1, kOld), 1.0);
}

TEST(Confidences, ThatBeginAnewAreTheMeanOfWhatWasSeenSince) {
  constexpr double kStep = 0.1;
  Confidences confidences;
  const double raw[] = {0.9, 0.5, 0.7};
  for (const double now : raw) {
    confidences.raw_current = now;
    confidences.age += kStep;
    smooth(confidences, smoothing_share({}, kStep, confidences.age));
  }
  EXPECT_NEAR(confidences.current, (0.9 + 0.5 + 0.7) / 3.0, 0.01) << "the later ones weigh a little more";
}

TEST(Confidences, GrowFromZeroWhereTheyAreToldTo) {
  ConfidenceParameters paper;
  paper.true_mean_start = false;
  EXPECT_EQ(smoothing_share(paper, 0.1, 0.1), smoothing_share(paper, 0.1, 1000.0));
}

TEST(Confidences, CountParticlesAroundBothViewCentresAndBehindTheGoals) {
  ViewFilter filter(1);
  filter.spread(3600);
  Confidences confidences;
  count_particles(confidences, filter, 1.0, {});
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

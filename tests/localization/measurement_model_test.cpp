// SPDX-License-Identifier: MIT
#include "localization/measurement/measurement_model.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "localization/reorientation.h"
#include "tests/localization/arbitrary_particles.h"
#include "tests/localization/synthetic_field.h"

namespace reorient {
namespace {

MeasurementModel& spl_model() {
  static MeasurementModel model{FieldDimensions(), MeasurementModelParameters()};
  return model;
}

FieldPercept any_percept() {
  SyntheticField field(FieldDimensions(), PerceptErrors(), *rc::gen::arbitrary<std::uint64_t>());
  return field.look(any_pose_on_carpet(), *rc::gen::inRange(-1500, 1500) * 1e-3, 0.0);
}

std::vector<float> costs_of(const MeasurementModel& model, const std::vector<Pose2>& poses) {
  ParticleSet particles(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) particles.set_pose(i, poses[i]);
  std::vector<float> costs;
  model.costs(particles, costs);
  return costs;
}

RC_GTEST_PROP(MeasurementModel, WeighsAParticleAndItsReflectionExactlyTheSame, ()) {
  MeasurementModel& model = spl_model();
  model.observe(any_percept());
  ParticleSet particles = any_particles();
  std::vector<float> costs;
  std::vector<float> reflected_costs;
  model.costs(particles, costs);
  flip_pose(particles);
  model.costs(particles, reflected_costs);
  RC_ASSERT(costs == reflected_costs);
}

RC_GTEST_PROP(MeasurementModel, GivesFiniteCostsWithinTheirLimits, ()) {
  MeasurementModel& model = spl_model();
  const MeasurementModelParameters p;
  model.observe(any_percept());
  std::vector<float> costs;
  model.costs(any_particles(), costs);
  const double limit = p.independent_points * p.line_point_cost_limit + 4.0 * p.goal_post_cost_limit;
  for (const float cost : costs) RC_ASSERT(cost >= 0.0f && static_cast<double>(cost) <= limit * 1.0001);
}

RC_GTEST_PROP(MeasurementModel, GivesTheTruePoseNearlyNoCostForExactPercepts, ()) {
  const Pose2 truth = any_pose_on_carpet();
  SyntheticField field(FieldDimensions(), {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 1);
  MeasurementModel& model = spl_model();
  model.observe(field.look(truth, *rc::gen::inRange(-1500, 1500) * 1e-3, 0.0));
  RC_ASSERT(costs_of(model, {truth})[0] <= 0.2f * static_cast<float>(model.terms()));
}

TEST(MeasurementModel, PrefersTheTruePoseToPosesBesideIt) {
  const Pose2 truth(-3.2, -3.5, kPi / 2.0);
  SyntheticField field(FieldDimensions(), PerceptErrors(), 1);
  MeasurementModel model{FieldDimensions(), MeasurementModelParameters()};
  model.observe(field.look(truth, 0.0, 0.0));
  const std::vector<float> costs = costs_of(
      model, {truth, truth * Pose2(0.5, 0.0, 0.0), truth * Pose2(0.0, 0.5, 0.0), truth * Pose2(0.0, 0.0, 0.3)});
  for (std::size_t i = 1; i < costs.size(); ++i) EXPECT_GT(costs[i], costs[0] + 1.0f) << i;
}

FeatureFits fits_at(const MeasurementModel& model, const FieldPercept& percept, const Pose2& pose) {
  ParticleSet one(1);
  one.set_pose(0, pose);
  FeatureFits fits;
  model.fits(percept, one, fits);
  return fits;
}

RC_GTEST_PROP(MeasurementModel, GivesFitsOfTheFeaturesWhoseSumIsTheCostOfThePose, ()) {
  MeasurementModelParameters p;
  p.line_points = 200;  // all
  p.independent_points = 200.0;
  static MeasurementModel model{FieldDimensions(), p};
  FieldPercept percept = any_percept();
  percept.line_points.resize(std::min<std::size_t>(percept.line_points.size(), 200));
  percept.goal_posts.resize(std::min<std::size_t>(percept.goal_posts.size(), 4));
  const Pose2 pose = any_pose_on_carpet();
  model.observe(percept);
  const FeatureFits fits = fits_at(model, percept, pose);
  RC_ASSERT(fits.line_points.size() == percept.line_points.size());
  RC_ASSERT(fits.goal_posts.size() == percept.goal_posts.size());
  double cost = 0.0;
  for (const float fit : fits.line_points) cost += std::max(fit, 0.0f) * p.line_point_cost_limit;
  for (const float fit : fits.goal_posts) cost += std::max(fit, 0.0f) * p.goal_post_cost_limit;
  RC_ASSERT(std::abs(cost - costs_of(model, {pose})[0]) < 1e-3 * (1.0 + cost));
}

TEST(MeasurementModel, RejectsFeaturesThatAreNotOnTheFieldAndIgnoresThoseOutOfRange) {
  MeasurementModel model{FieldDimensions(), MeasurementModelParameters()};
  FieldPercept percept;
  const auto add = [&](double x, double y) { percept.line_points.emplace_back().position = {x, y}; };
  add(1.0, 0.0);    // on the halfway line
  add(2.0, 0.0);    // beside it
  add(0.01, 0.0);   // on the robot
  add(100.0, 0.0);  // too far
  add(std::nan(""), 0.0);
  percept.goal_posts = {goal_post({2.0, 0.0}), goal_post({std::nan(""), 0.0})};
  const FeatureFits fits = fits_at(model, percept, {-1.0, 2.0, 0.0});
  EXPECT_LT(fits.line_points[0], 0.2f);
  EXPECT_EQ(fits.line_points[1], 1.0f);
  for (const std::size_t unused : {2u, 3u, 4u}) EXPECT_EQ(fits.line_points[unused], FeatureFits::kIgnored) << unused;
  EXPECT_EQ(fits.goal_posts[0], 1.0f);
  EXPECT_EQ(fits.goal_posts[1], FeatureFits::kIgnored);
}

TEST(MeasurementModel, MatchesAGoalPostWithAnyOfTheFour) {
  MeasurementModel model{FieldDimensions(), MeasurementModelParameters()};
  FieldPercept percept;
  percept.goal_posts.push_back(goal_post({2.0, 0.0}));
  model.observe(percept);
  const std::vector<float> costs =
      costs_of(model, {{2.5, 0.8, 0.0}, {2.5, -0.8, 0.0}, {-2.5, 0.8, kPi}, {-2.5, -0.8, kPi}});
  for (const float cost : costs) EXPECT_NEAR(cost, 0.0, 1e-4);
  EXPECT_GT(costs_of(model, {{0.0, 0.0, 0.0}})[0], 1.0f);
}

TEST(MeasurementModel, TrustsTheBearingButHardlyTheDistanceOfAPostWhoseBaseIsHidden) {
  MeasurementModel model{FieldDimensions(), MeasurementModelParameters()};
  FieldPercept percept;
  percept.goal_posts.push_back(goal_post({3.0, 0.0}, false));
  model.observe(percept);
  const std::vector<float> costs = costs_of(model, {{2.5, 0.8, 0.0}, {1.5, 0.8, 0.2}});
  EXPECT_LT(costs[0], 0.5f);
  EXPECT_GT(costs[1], 2.0f);
}

TEST(MeasurementModel, IgnoresPerceptsThatAreNotFiniteTooNearOrTooFar) {
  MeasurementModel model{FieldDimensions(), MeasurementModelParameters()};
  FieldPercept percept;
  for (const Eigen::Vector2d& position :
       {Eigen::Vector2d(kNaN, 1.0), Eigen::Vector2d(1.0, kInfinity), Eigen::Vector2d(-kInfinity, kNaN),
        Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1e30, 0.0), Eigen::Vector2d(1e300, 1e300)}) {
    percept.line_points.push_back(line_point(position, 0.0));
    percept.goal_posts.push_back(goal_post(position));
  }
  percept.line_points.push_back(line_point({1.0, 0.0}, kNaN));
  model.observe(percept);
  EXPECT_EQ(model.line_points(), 0u);
  EXPECT_EQ(model.goal_posts(), 0u);
  EXPECT_EQ(model.terms(), 0.0);
  EXPECT_EQ(costs_of(model, {Pose2()})[0], 0.0f);
}

RC_GTEST_PROP(MeasurementModel, UsesAsManyLinePointsAsTheParameterAllows, ()) {
  const int given = *rc::gen::inRange(0, 300);
  MeasurementModelParameters parameters;
  parameters.line_points = *rc::gen::inRange(1, 200);
  static MeasurementModel model{FieldDimensions(), parameters};
  model.set_parameters(parameters);
  FieldPercept percept;
  for (int i = 0; i < given; ++i) percept.line_points.push_back(line_point({1.0, 0.0}, 0.0));
  model.observe(percept);
  RC_ASSERT(model.line_points() == static_cast<std::size_t>(std::min(given, parameters.line_points)));
}

TEST(MeasurementModel, UsesAtMostFourGoalPosts) {
  MeasurementModel model{FieldDimensions(), MeasurementModelParameters()};
  FieldPercept percept;
  percept.goal_posts.assign(50, goal_post({2.0, 0.0}));
  model.observe(percept);
  EXPECT_EQ(model.goal_posts(), 4u);
}

}  // namespace
}  // namespace reorient

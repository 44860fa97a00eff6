// SPDX-License-Identifier: MIT
#include "localization/pose_filter.h"

#include <set>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "localization/measurement/field_map.h"
#include "localization/reorientation.h"
#include "tests/localization/arbitrary_particles.h"
#include "tests/localization/synthetic_field.h"

namespace reorient {
namespace {

PoseFilter spl_filter(std::uint64_t seed = 1) { return {PoseFilterParameters(), FieldDimensions(), seed}; }

std::vector<float> state_of(const PoseFilter& filter) {
  const ParticleSet& particles = filter.particles();
  std::vector<float> values;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    values.insert(values.end(), {particles.x[i], particles.y[i], static_cast<float>(to_radians(particles.rotation[i])),
                                 particles.weight[i]});
  }
  return values;
}

bool near(const Pose2& a, const Pose2& b) {
  return (a.position - b.position).norm() < 0.15 && std::abs(angle_difference(a.rotation, b.rotation)) < 0.1;
}

/// A percept with any numbers, also infinite ones and NaN.
FieldPercept any_hostile_percept() {
  const auto number = [] {
    return *rc::gen::oneOf(rc::gen::element(kNaN, kInfinity, -kInfinity, 0.0, 1e-300, -1e300),
                           rc::gen::map(rc::gen::inRange(-6000, 6000), [](int n) { return n * 1e-3; }));
  };
  FieldPercept percept;
  for (int i = *rc::gen::inRange(0, 60); i > 0; --i) {
    const double x = number();
    const double y = number();
    percept.line_points.push_back(line_point({x, y}, number()));
  }
  for (int i = *rc::gen::inRange(0, 6); i > 0; --i) {
    const double x = number();
    percept.goal_posts.push_back(goal_post({x, number()}, *rc::gen::arbitrary<bool>()));
  }
  return percept;
}

TEST(PoseFilter, BelievesTheInitialPose) {
  PoseFilter filter = spl_filter();
  const Pose2 start(-3.2, -3.5, kPi / 2.0);
  filter.set_initial_pose(start, 0.1, 0.05);
  EXPECT_TRUE(near(filter.belief().pose, start));
  EXPECT_GT(filter.belief().cluster_weight, 0.99);
  EXPECT_EQ(filter.belief().reflected_weight, 0.0);
}

TEST(PoseFilter, StartsWithParticlesAllOverTheCarpet) {
  const PoseFilter filter = spl_filter();
  std::set<std::pair<int, int>> squares;
  for (std::size_t i = 0; i < filter.particles().size(); ++i) {
    const Pose2 pose = filter.particles().pose(i);
    EXPECT_LE(std::abs(pose.position.x()), 5.2);
    EXPECT_LE(std::abs(pose.position.y()), 3.7);
    squares.insert({static_cast<int>(std::floor(pose.position.x())), static_cast<int>(std::floor(pose.position.y()))});
  }
  EXPECT_GT(squares.size(), 60u);
  EXPECT_LT(filter.belief().cluster_weight, 0.3);
}

TEST(PoseFilter, StartsAnywhereWhenTheInitialPoseIsInvalid) {
  PoseFilter filter = spl_filter();
  filter.set_initial_pose({kNaN, 0.0, 0.0}, 0.1, 0.1);
  filter.set_initial_pose({0.0, 0.0, 0.0}, kInfinity, 0.1);
  EXPECT_TRUE(filter.belief().pose.position.allFinite());
  EXPECT_LT(filter.belief().cluster_weight, 0.3);
}

TEST(PoseFilter, FollowsTheOdometryWhileNothingIsSeen) {
  PoseFilter filter = spl_filter();
  filter.set_initial_pose({-2.0, 0.0, 0.0}, 0.01, 0.01);
  for (int i = 0; i < 30; ++i) {
    filter.predict({0.01, 0.0, 0.0}, 1.0 / 30.0);
    EXPECT_NEAR(filter.belief().pose.position.x(), -2.0 + 0.01 * (i + 1), 0.1);
    filter.update(FieldPercept(), SeenGoal::unknown);
  }
  EXPECT_TRUE(near(filter.belief().pose, {-1.7, 0.0, 0.0}));
}

TEST(PoseFilter, FlipsParticlesAndBeliefWithinTheCall) {
  PoseFilter filter = spl_filter();
  const Pose2 start(-3.2, 1.0, 0.5);
  filter.set_initial_pose(start, 0.1, 0.05);
  const PoseBelief before = filter.belief();
  filter.flip_pose();
  EXPECT_TRUE(near(filter.belief().pose, reflect(start)));
  EXPECT_EQ(filter.belief().cluster_weight, before.cluster_weight);
  // A new search in the mirrored particles finds the same belief.
  PoseClusters clusters{FieldDimensions()};
  const PoseBelief found = clusters.find(filter.particles(), filter.belief(), {});
  EXPECT_TRUE(found.covariance.isApprox(filter.belief().covariance, 1e-3));
  EXPECT_TRUE(near(found.pose, filter.belief().pose));
}

TEST(PoseFilter, IsUnchangedAfterTwoFlips) {
  PoseFilter filter = spl_filter();
  filter.set_initial_pose({-3.2, 1.0, 0.5}, 0.5, 0.5);
  const std::vector<float> before = state_of(filter);
  const Pose2 pose = filter.belief().pose;
  filter.flip_pose();
  EXPECT_NE(state_of(filter), before);
  filter.flip_pose();
  EXPECT_EQ(state_of(filter), before);
  EXPECT_NEAR((filter.belief().pose.position - pose.position).norm(), 0.0, 1e-12);
}

TEST(PoseFilter, PurgesTheReflectionWithinTheCall) {
  PoseFilter filter = spl_filter();
  filter.set_initial_pose({-3.2, 1.0, 0.5}, 0.1, 0.05);
  InjectionParameters strong;
  // A known goal that contradicts the belief creates a second cluster.
  PoseFilterParameters parameters;
  parameters.injection.known_goal_rate = 0.3;
  filter.set_parameters(parameters);
  SyntheticRobot robot(filter, {-3.2, 1.0, kPi}, 1);
  filter.set_initial_pose(robot.truth, 0.1, 0.05);
  for (int i = 0; i < 300 && filter.belief().reflected_weight < 0.1; ++i) robot.stand(SeenGoal::opponent);
  ASSERT_GT(filter.belief().reflected_weight, 0.1);
  const Pose2 believed = filter.belief().pose;
  filter.purge_reflection();
  EXPECT_EQ(filter.belief().reflected_weight, 0.0);
  EXPECT_TRUE(near(filter.belief().pose, believed));
}

TEST(PoseFilter, ForgetsTheRotationButNotThePositionOnAReset) {
  PoseFilter filter = spl_filter();
  const Pose2 start(-3.2, 1.0, 0.5);
  filter.set_initial_pose(start, 0.05, 0.05);
  filter.reset_orientation();
  EXPECT_LT((filter.belief().pose.position - start.position).norm(), 0.1);
  EXPECT_LT(filter.belief().cluster_weight, 0.5);
}

RC_GTEST_PROP(PoseFilter, StaysFiniteWithAnyInput, ()) {
  PoseFilter filter = spl_filter();
  for (int frame = *rc::gen::inRange(1, 20); frame > 0; --frame) {
    const double extreme = *rc::gen::element(kNaN, kInfinity, -kInfinity, 1e300, 0.0, 0.01);
    filter.predict({extreme, 0.0, *rc::gen::element(kNaN, 0.0, 1e9)}, *rc::gen::element(kNaN, kInfinity, -1.0, 0.03));
    filter.update(any_hostile_percept(), *rc::gen::element(SeenGoal::unknown, SeenGoal::opponent, SeenGoal::own));
  }
  for (const float value : state_of(filter)) RC_ASSERT(std::isfinite(value));
  const PoseBelief& belief = filter.belief();
  RC_ASSERT(belief.pose.position.allFinite() && std::isfinite(belief.pose.rotation) && belief.covariance.allFinite());
  const Eigen::Vector2d limit = believable_half_size(FieldDimensions());
  RC_ASSERT((belief.pose.position.cwiseAbs().array() <= limit.array() + 1e-6).all());
}

TEST(PoseFilter, GivesTheSameResultOnlyWithTheSameSeed) {
  const auto run = [](std::uint64_t seed) {
    PoseFilter filter = spl_filter(seed);
    filter.set_initial_pose({-3.2, 0.0, 0.0}, 0.2, 0.1);
    SyntheticRobot robot(filter, {-3.2, 0.0, 0.0}, 9);
    for (int i = 0; i < 100; ++i) robot.walk(SeenGoal::opponent);
    filter.reset_orientation();
    filter.purge_reflection();
    return state_of(filter);
  };
  EXPECT_EQ(run(3), run(3));
  EXPECT_NE(run(3), run(4));
}

TEST(PoseFilter, ChangesItsNumberOfParticlesWhileItRuns) {
  PoseFilter filter = spl_filter();
  const Pose2 start(1.0, 1.0, 1.0);
  filter.set_initial_pose(start, 0.1, 0.05);
  PoseFilterParameters parameters;
  for (const int count : {50, 500, 10, 0}) {
    parameters.particles = count;
    filter.set_parameters(parameters);
    EXPECT_EQ(filter.particles().size(), static_cast<std::size_t>(std::max(1, count)));
    EXPECT_LT((filter.belief().pose.position - start.position).norm(), 0.4);
    filter.predict(Pose2(), 1.0 / 30.0);
    filter.update(FieldPercept(), SeenGoal::unknown);
  }
}

TEST(PoseFilter, IsNotLostAfterOneBadFrameThatFollowsALongGap) {
  PoseFilter filter = spl_filter();
  const Pose2 start(-3.2, 0.0, 0.0);
  filter.set_initial_pose(start, 0.1, 0.05);
  SyntheticRobot robot(filter, start, 1);
  robot.stand_for(10.0);
  filter.predict(Pose2(), 3.0);
  robot.truth = {-1.5, 1.0, 0.0};
  robot.stand();
  EXPECT_EQ(filter.recovery().recovery_probability(InjectionParameters().lost_margin), 0.0);
  robot.stand_for(0.5);
  EXPECT_GT(filter.recovery().recovery_probability(InjectionParameters().lost_margin), 0.0);
}

TEST(PoseFilter, IsNotLostAfterAFewFramesWithOneFalsePost) {
  PoseFilter filter = spl_filter();
  const Pose2 start(-3.2, -3.5, 0.5 * kPi);
  filter.set_initial_pose(start, 0.1, 0.05);
  SyntheticRobot robot(filter, start, 1);
  robot.stand_for(10.0);
  FieldPercept post;
  post.goal_posts.push_back({{1.5, 0.7}, true, {}, {}});
  for (int i = 0; i < 4; ++i) {
    filter.predict(Pose2(), 0.4);  // it sees nothing in between
    filter.update(post, SeenGoal::unknown);
  }
  EXPECT_FALSE(filter.is_lost());
}

TEST(PoseFilter, IsLostAfterItHasSeenNothingForLong) {
  PoseFilter filter = spl_filter();
  filter.see_nothing(30.0);  // has no effect before the first fit
  const Pose2 start(-3.2, 0.0, 0.0);
  filter.set_initial_pose(start, 0.1, 0.05);
  SyntheticRobot robot(filter, start, 1);
  robot.stand_for(10.0);
  const auto probability = [&] { return filter.recovery().recovery_probability(InjectionParameters().lost_margin); };
  const auto see_nothing_for = [&](double seconds) {
    for (double time = 0.0; time < seconds; time += 0.1) filter.see_nothing(0.1);
  };
  see_nothing_for(3.0);
  EXPECT_EQ(probability(), 0.0);
  see_nothing_for(12.0);
  EXPECT_GT(probability(), 0.3);
  robot.stand_for(3.0);  // the belief was correct the whole time
  EXPECT_EQ(probability(), 0.0);
  EXPECT_TRUE(robot.believes_truth());
}

TEST(PoseFilter, InjectsNothingWhenInjectionIsSwitchedOff) {
  PoseFilterParameters parameters;
  parameters.injection.enabled = false;
  parameters.injection.known_goal_rate = 0.5;
  PoseFilter filter(parameters, FieldDimensions(), 1);
  const Pose2 believed(-2.0, 1.0, kPi);
  filter.set_initial_pose(believed, 0.1, 0.05);
  SyntheticRobot robot(filter, believed, 1);
  robot.stand_for(5.0, SeenGoal::opponent);  // wrong: injected particles would be at the reflection
  EXPECT_EQ(filter.belief().reflected_weight, 0.0);
}

TEST(PoseFilter, AppendsFourNumbersAndOnePoseForEachParticle) {
  const PoseFilter filter = spl_filter();
  std::vector<Pose2> poses;
  filter.append_poses(poses);
  EXPECT_EQ(poses.size(), filter.particles().size());
  EXPECT_EQ(state_of(filter).size(), 4 * filter.particles().size());
}

/// Replaces the engine's registry: collects names, and checks that defaults are within their ranges.
struct Registry {
  std::set<std::string>& names;
  template <typename Number>
  void operator()(const char* name, Number& value, Number min, Number max, const char*, const char* description) {
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_LE(min, value) << name;
    EXPECT_GE(max, value) << name;
    EXPECT_STRNE(description, "") << name;
  }
  void operator()(const char* name, bool&, const char* description) {
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_STRNE(description, "") << name;
  }
};

TEST(PoseFilter, DescribesEachParameterOnceWithADefaultInItsRange) {
  PoseFilterParameters parameters;
  const auto count = [](auto& part) {
    std::set<std::string> names;
    describe(part, Registry{names});
    return names.size();
  };
  EXPECT_EQ(count(parameters), 2u);
  EXPECT_EQ(count(parameters.motion), sizeof(MotionModelParameters) / sizeof(double));
  EXPECT_EQ(count(parameters.measurement), sizeof(MeasurementModelParameters) / sizeof(double));
  EXPECT_EQ(count(parameters.injection), 14u);
  EXPECT_EQ(count(parameters.clusters), sizeof(PoseClusterParameters) / sizeof(double));
}

}  // namespace
}  // namespace reorient

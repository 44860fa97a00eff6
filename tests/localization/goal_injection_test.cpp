// SPDX-License-Identifier: MIT
#include "localization/measurement/goal_injection.h"

#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/localization/arbitrary_particles.h"
#include "tests/localization/synthetic_field.h"

namespace reorient {
namespace {

GoalPost post_at(const Pose2& robot, const Eigen::Vector2d& in_field, bool base_visible = true) {
  return goal_post(robot.inverse() * in_field, base_visible);
}

/// Percepts of the opponent goal and of the lines, without errors.
struct Scene {
  explicit Scene(const Pose2& robot, bool both_posts = true) {
    SyntheticField field(FieldDimensions(), {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 1);
    const Eigen::Vector2d goal = robot.inverse() * Eigen::Vector2d(4.5, 0.0);
    percept = field.look(robot, std::atan2(goal.y(), goal.x()), 0.0);
    percept.goal_posts.clear();
    percept.goal_posts.push_back(post_at(robot, {4.5, 0.8}));
    if (both_posts) percept.goal_posts.push_back(post_at(robot, {4.5, -0.8}));
    model.observe(percept);
  }
  FieldPercept percept;
  MeasurementModel model{FieldDimensions(), MeasurementModelParameters()};
};

const Pose2 kRobot(2.0, 1.0, -0.2);
const InjectionParameters kParameters;
const MeasurementModel kNothingObserved{FieldDimensions(), MeasurementModelParameters()};

TEST(GoalInjection, DrawsPosesNearTheTruthFromTwoPostsOfAKnownGoal) {
  const Scene scene(kRobot);
  GoalInjection injection{FieldDimensions()};
  const auto goal = injection.find_goal(scene.percept, scene.model, kParameters);
  ASSERT_TRUE(goal && goal->right);
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const auto pose = injection.draw(*goal, SeenGoal::opponent, scene.model, kParameters, random);
    ASSERT_TRUE(pose);
    EXPECT_LT((pose->position - kRobot.position).norm(), 0.5);
    EXPECT_LT(std::abs(angle_difference(pose->rotation, kRobot.rotation)), 0.25);
  }
}

TEST(GoalInjection, DrawsTheReflectionWhenTheOwnGoalIsSeen) {
  const Scene scene(kRobot);
  GoalInjection injection{FieldDimensions()};
  const auto goal = injection.find_goal(scene.percept, scene.model, kParameters);
  Random random(1);
  const auto pose = injection.draw(goal.value(), SeenGoal::own, scene.model, kParameters, random);
  ASSERT_TRUE(pose);
  EXPECT_LT((pose->position + kRobot.position).norm(), 0.5);
}

TEST(GoalInjection, DrawsPoseAndReflectionEquallyOftenWhileTheGoalIsUnknown) {
  const Scene scene(kRobot);
  GoalInjection injection{FieldDimensions()};
  const auto goal = injection.find_goal(scene.percept, scene.model, kParameters);
  InjectionParameters quick;
  quick.candidates = 3;
  Random random(1);
  int at_truth = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto pose = injection.draw(goal.value(), SeenGoal::unknown, scene.model, quick, random);
    if (pose.value().position.x() > 0.0) ++at_truth;
  }
  EXPECT_NEAR(at_truth, 500, 60);
}

TEST(GoalInjection, DrawsPosesAtTheMeasuredDistanceFromASinglePost) {
  const Scene scene(kRobot, false);
  GoalInjection injection{FieldDimensions()};
  const auto goal = injection.find_goal(scene.percept, scene.model, kParameters);
  ASSERT_TRUE(goal && !goal->right);
  const double seen = goal->left.norm();
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const auto pose = injection.draw(*goal, SeenGoal::opponent, scene.model, kParameters, random);
    ASSERT_TRUE(pose);
    const double left = (Eigen::Vector2d(4.5, 0.8) - pose->position).norm();
    const double right = (Eigen::Vector2d(4.5, -0.8) - pose->position).norm();
    EXPECT_LT(std::min(std::abs(left - seen), std::abs(right - seen)), 1.0);
  }
}

TEST(GoalInjection, NeedsLinePointsBesideASinglePost) {
  const Scene scene(kRobot, false);
  const GoalInjection injection{FieldDimensions()};
  EXPECT_FALSE(injection.find_goal(scene.percept, kNothingObserved, kParameters));
}

TEST(GoalInjection, IgnoresASinglePostWhoseBaseIsHidden) {
  FieldPercept percept;
  percept.goal_posts.push_back(post_at(kRobot, {4.5, 0.8}, false));
  EXPECT_FALSE(GoalInjection{FieldDimensions()}.find_goal(percept, Scene(kRobot).model, kParameters));
}

TEST(GoalInjection, DistinguishesLeftFromRightInAnyOrderOfThePosts) {
  const Scene scene(kRobot);
  FieldPercept swapped = scene.percept;
  std::swap(swapped.goal_posts[0], swapped.goal_posts[1]);
  const GoalInjection injection{FieldDimensions()};
  EXPECT_EQ(injection.find_goal(scene.percept, kNothingObserved, kParameters)->left,
            injection.find_goal(swapped, kNothingObserved, kParameters)->left);
}

TEST(GoalInjection, SelectsTheTwoPostsWithTheDistanceOfAGoal) {
  Scene scene(kRobot);
  scene.percept.goal_posts.insert(scene.percept.goal_posts.begin(), post_at(kRobot, {3.0, 2.1}));
  const auto goal = GoalInjection{FieldDimensions()}.find_goal(scene.percept, kNothingObserved, kParameters);
  ASSERT_TRUE(goal && goal->right);
  EXPECT_LT((goal->left - kRobot.inverse() * Eigen::Vector2d(4.5, 0.8)).norm(), 1e-9);
  EXPECT_LT((*goal->right - kRobot.inverse() * Eigen::Vector2d(4.5, -0.8)).norm(), 1e-9);
}

TEST(GoalInjection, FindsNoGoalAmongPostsThatAreNotFiniteOrFarAway) {
  FieldPercept percept;
  for (const double bad : {kNaN, std::numeric_limits<double>::infinity(), 1e200, 0.0}) {
    percept.goal_posts.push_back(goal_post({bad, bad}));
  }
  EXPECT_FALSE(GoalInjection{FieldDimensions()}.find_goal(percept, Scene(kRobot).model, kParameters));
}

TEST(GoalInjection, UsesPostsUpToTheLargestDistanceOfTheModel) {
  FieldPercept percept;
  percept.goal_posts = {goal_post({11.0, 0.8}), goal_post({11.0, -0.8})};
  EXPECT_FALSE(GoalInjection{FieldDimensions()}.find_goal(percept, kNothingObserved, kParameters));
  MeasurementModelParameters high;
  high.farthest_goal_post = 16.0;
  const MeasurementModel model(FieldDimensions(), high);
  EXPECT_TRUE(GoalInjection{FieldDimensions()}.find_goal(percept, model, kParameters));
}

RC_GTEST_PROP(GoalInjection, DrawsOnlyFinitePosesOnTheCarpet, ()) {
  static const Scene scene(kRobot);
  GoalInjection injection{FieldDimensions()};
  const auto any_meters = [] { return *rc::gen::inRange(-7000, 7000) * 1e-3; };
  GoalSighting goal;
  goal.left.x() = any_meters();
  goal.left.y() = any_meters();
  RC_PRE(goal.left.norm() > 0.1);
  if (*rc::gen::arbitrary<bool>()) {
    const double turn = any_meters();
    goal.right = goal.left + 1.6 * Eigen::Vector2d(std::cos(turn), std::sin(turn));
    RC_PRE(goal.right->norm() > 0.1);
  }
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const auto pose = injection.draw(goal, SeenGoal::unknown, scene.model, kParameters, random);
  const Eigen::Vector2d limit = carpet_half_size(FieldDimensions());
  if (pose) RC_ASSERT((pose->position.cwiseAbs().array() <= limit.array()).all() && std::isfinite(pose->rotation));
}

}  // namespace
}  // namespace reorient

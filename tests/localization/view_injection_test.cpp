// SPDX-License-Identifier: MIT
#include "localization/measurement/view_injection.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/transform.h"
#include "localization/pose_filter.h"
#include "tests/localization/synthetic_field.h"

namespace reorient {
namespace {

/// The view of a robot whose camera looks `yaw` to the left, at a wall 8 m away from the center of the field.
SeenView view_from(const Pose2& robot, double yaw, double deviation = 0.2) {
  return {.azimuth = azimuth_from(robot, yaw, 8.0), .deviation = deviation, .radius = 8.0, .direction = yaw};
}

RC_GTEST_PROP(ViewInjection, GivesEachPositionTheHeadingThatFitsTheView, ()) {
  const auto number = [](int least, int most) { return *rc::gen::inRange(least, most) * 1e-3; };
  const Pose2 robot(number(-5000, 5000), number(-3500, 3500), number(-3141, 3141));
  const SeenView view = view_from(robot, number(-2000, 2000));
  RC_ASSERT(std::abs(angle_difference(heading_of_view(view, robot.position, view.azimuth), robot.rotation)) < 1e-9);
}

TEST(ViewInjection, DrawsPosesOnTheCarpetOfWhichSomeAreNearTheTruth) {
  const Pose2 robot(2.0, 1.0, -0.2);
  SyntheticField field(FieldDimensions(), {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 1);
  MeasurementModel model{FieldDimensions(), MeasurementModelParameters()};
  model.observe(field.look(robot, 0.3, 0.0));
  ViewInjection injection{FieldDimensions()};
  const Eigen::Vector2d carpet = carpet_half_size(FieldDimensions());
  Random random(1);
  int near = 0, turned_away = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose2 pose = injection.draw(view_from(robot, 0.3), model, InjectionParameters(), random);
    constexpr double kRounding = 1e-6;  // m, of single precision
    EXPECT_TRUE((pose.position.cwiseAbs().array() <= carpet.array() + kRounding).all());
    if ((pose.position - robot.position).norm() < 0.5) ++near;
    // The heading depends on the position on the field, so it differs by more than the view's deviation.
    if (std::abs(angle_difference(pose.rotation, robot.rotation)) > 1.8) ++turned_away;
  }
  EXPECT_GT(near, 20);
  EXPECT_EQ(turned_away, 0);
}

/// A robot that stood at its initial pose for 10 s and was then moved without odometry. It sees no goals.
struct KidnappedRobot {
  explicit KidnappedRobot(bool use_view, std::uint64_t seed) : filter(parameters(use_view), FieldDimensions(), seed) {
    filter.set_initial_pose(robot.truth, 0.1, 0.05);
    robot.stand_for(10.0);
    robot.truth = {2.0, 1.5, 2.5};
    filter.doubt();
  }
  static PoseFilterParameters parameters(bool use_view) {
    PoseFilterParameters parameters;
    parameters.injection.use_view = use_view;
    return parameters;
  }

  PoseFilter filter;
  SyntheticRobot robot{filter, {-3.2, 0.0, 0.0}, 7, PerceptErrors{.missed_posts = 1.0}};
};

TEST(LostRobot, FindsItsPoseByTheViewWithoutAGoal) {
  int with = 0, without = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const bool use_view : {true, false}) {
      KidnappedRobot kidnapped(use_view, seed);
      kidnapped.robot.wall_radius = 8.0;
      kidnapped.robot.stand_for(6.0);
      if (kidnapped.robot.believes_truth()) ++(use_view ? with : without);
    }
  }
  EXPECT_GE(with, 9);
  EXPECT_LE(without, with - 5);
}

TEST(LostRobot, IsNotChangedByAViewWhileItsPoseFits) {
  PoseFilter plain(KidnappedRobot::parameters(true), FieldDimensions(), 1), viewing = plain;
  const Pose2 start(-3.2, 1.0, 0.3);
  std::vector<SyntheticRobot> robots;
  for (PoseFilter* const filter : {&plain, &viewing}) {
    filter->set_initial_pose(start, 0.1, 0.05);
    robots.emplace_back(*filter, start, 3);
  }
  robots[1].wall_radius = 8.0;
  for (SyntheticRobot& robot : robots) robot.stand_for(10.0);
  EXPECT_EQ(plain.belief().pose.position, viewing.belief().pose.position);
  EXPECT_EQ(plain.belief().pose.rotation, viewing.belief().pose.rotation);
}

TEST(LostRobot, DecidesTheSideOfAnUnknownGoalByTheView) {
  int right = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    PoseFilter filter(PoseFilterParameters(), FieldDimensions(), seed);  // starts globally, so it is lost
    SyntheticRobot robot(filter, {-2.0, 1.0, 0.4}, seed);
    robot.wall_radius = 8.0;
    robot.stand_for(6.0);
    if (robot.believes_truth()) ++right;
  }
  EXPECT_GE(right, 9);
}

}  // namespace
}  // namespace reorient

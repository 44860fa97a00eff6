// SPDX-License-Identifier: MIT
// Filter, tracker and search together.
#include "localization/localizer.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/localization/biased_camera.h"

namespace reorient {
namespace {

constexpr double kFrame = 1.0 / 30.0;  // s

/// A robot that stands or turns on the spot.
struct StandingRobot {
  explicit StandingRobot(const Pose2& pose) : robot(pose), localizer({}, FieldDimensions(), 1) {}

  void tell_its_pose() { localizer.set_initial_pose(robot, 0.1, 0.05); }

  /// Sees what is there, or nothing, with the head at these angles, while it turns on the spot (rad/s).
  void see_for(double seconds, const HeadAngles& head, bool sees_field, double turning = 0.0) {
    for (const double end = time + seconds; time < end; time += kFrame) {
      const Pose2 step(0.0, 0.0, turning * kFrame);
      robot = robot * step;
      odometry = odometry * step;
      const CameraBias known = localizer.bias();
      const FieldPercept percept = sees_field ? camera.look(robot, head, known) : FieldPercept();
      LocalizerInputs inputs;
      inputs.time = time;
      inputs.time_step = kFrame;
      inputs.odometry = odometry;
      inputs.odometry_step = step;
      inputs.seen[0] = {&percept, corrected(BiasedCamera::measured(head), known, 0), &model};
      sensed = localizer.update(inputs);
    }
  }

  /// The same with a head that looks around.
  void look_around() {
    for (int i = 0; i < 6; ++i) see_for(0.5 * kFrame, scanning_head(time), true);
  }
  double stated_deviation() const { return std::sqrt(sensed.belief.covariance(0, 0)); }  ///< along x, m

  Pose2 robot;
  Pose2 odometry;
  BiasedCamera camera{CameraBias(), 0.5, 1};
  CameraModel model = CameraModel::from_fields_of_view(640, 480, from_degrees(56.3), from_degrees(43.7));
  Localizer localizer;
  SensedBelief sensed;
  double time = 0.0;
};

TEST(Localizer, IsLostAfterItHasSeenNothingWhereLinesShouldBe) {
  StandingRobot robot({-1.5, 0.0, 0.0});
  robot.tell_its_pose();
  robot.see_for(5.0, {0.0, 0.3}, true);
  EXPECT_TRUE(robot.sensed.tracked);
  robot.see_for(15.0, {0.0, 0.3}, false);
  EXPECT_FALSE(robot.sensed.tracked);
}

TEST(Localizer, IsNotLostWhileItLooksAwayFromTheField) {
  StandingRobot robot({-3.2, -3.3, 0.5 * kPi});
  robot.tell_its_pose();
  robot.see_for(5.0, {0.0, 0.3}, true);
  robot.see_for(5.0, {0.0, 0.3}, true, 0.2 * kPi);
  robot.see_for(60.0, {0.0, 0.0}, false);
  EXPECT_TRUE(robot.sensed.tracked);
}

TEST(Localizer, DoubtsAPoseThatItHasJustFound) {
  StandingRobot robot({-1.5, 1.0, 0.4});
  robot.look_around();
  EXPECT_FALSE(robot.sensed.tracked);
  EXPECT_GT(robot.stated_deviation(), 1.0);
  while (!robot.sensed.tracked && robot.time < 20.0) robot.look_around();
  ASSERT_TRUE(robot.sensed.tracked);
  EXPECT_GT(robot.stated_deviation(), 0.3);
  EXPECT_LT(robot.stated_deviation(), 1.0);
  for (int i = 0; i < 100; ++i) robot.look_around();
  EXPECT_LT(robot.stated_deviation(), 0.1);
}

}  // namespace
}  // namespace reorient

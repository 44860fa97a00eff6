// SPDX-License-Identifier: MIT
#include "engine/world/seen_view.h"

#include <gtest/gtest.h>

#include "localization/measurement/view_injection.h"
#include "tests/perception/room/painted_room.h"

namespace reorient {
namespace {

/// A robot that has learned the whole room for a minute and was then placed at another position.
test::ScanningRobot carried_robot(const test::PaintedRoom& room) {
  test::ScanningRobot robot(room, RoomParameters(), 1);
  for (int i = 0; i < 8; ++i) {
    robot.truth = robot.belief = {-1.0, -0.5, i * kPi / 4.0};
    robot.run(8.0);
  }
  robot.train = false;
  robot.truth = {1.0, 1.0, 2.0};
  robot.belief = {-1.0, -0.5, -0.5};
  robot.awareness.restart();
  robot.run(2.0);
  return robot;
}

/// The odometry of such a robot never rotates.
std::optional<SeenView> view_of(const test::ScanningRobot& robot) {
  return seen_view(robot.awareness, 0.0, SeenViewParameters());
}

TEST(SeenView, GivesTheHeadingOfARobotWhoseBeliefIsWrong) {
  const test::ScanningRobot robot = carried_robot(test::PaintedRoom::colorful(1));
  const std::optional<SeenView> view = view_of(robot);
  ASSERT_TRUE(view);
  const double heading = heading_of_view(*view, robot.truth.position, view->azimuth);
  EXPECT_LT(std::abs(angle_difference(heading, robot.truth.rotation)), 2.0 * view->deviation);
}

TEST(SeenView, IsMissingInARoomThatLooksTheSameAfterARotationBy180Degrees) {
  EXPECT_FALSE(view_of(carried_robot(test::PaintedRoom::symmetric(1))));
  EXPECT_FALSE(view_of(carried_robot(test::PaintedRoom::plain())));
}

TEST(SeenView, IsMissingBeforeTheRoomIsLearned) {
  test::ScanningRobot robot(test::PaintedRoom::colorful(1), RoomParameters(), 1);
  EXPECT_FALSE(view_of(robot));
  robot.train = false;
  robot.run(1.0);
  EXPECT_FALSE(view_of(robot));
}

}  // namespace
}  // namespace reorient

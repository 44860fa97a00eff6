// SPDX-License-Identifier: MIT
// Invalid views in any order. They must not crash the program or move a confidence out of its range.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/perception/room/painted_room.h"

namespace reorient {
namespace {

void expect_sound(const Confidences& confidences) {
  for (const double value :
       {confidences.current, confidences.opposite, confidences.raw_current, confidences.raw_opposite,
        confidences.goal_opponent, confidences.goal_own, confidences.coverage, confidences.distinctiveness}) {
    ASSERT_GE(value, 0.0);
    ASSERT_LE(value, 1.0);
  }
  ASSERT_TRUE(std::isfinite(confidences.evidence));
}

TEST(HostileViews, KeepTheConfidencesValidAndTheModelUnchanged) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  test::ScanningRobot robot(test::PaintedRoom::colorful(1), {}, 1);
  robot.run(6.0);
  const double coverage = robot.awareness.confidences().coverage;
  const auto try_view = [&](auto&& spoil) {
    RoomObservation view = robot.look();
    spoil(view);
    robot.awareness.update(view);
    expect_sound(robot.awareness.confidences());
    EXPECT_EQ(robot.awareness.confidences().visible_tiles, 0);
    EXPECT_EQ(robot.awareness.confidences().coverage, coverage);
  };
  try_view([](RoomObservation& view) { view.image = {}; });
  try_view([](RoomObservation& view) { view.image.height = -1; });
  try_view([&](RoomObservation& view) { view.belief.position.x() = nan; });
  try_view([&](RoomObservation& view) { view.belief.rotation = nan; });
  try_view([](RoomObservation& view) { view.belief.position = {100, 100}; });
  try_view([&](RoomObservation& view) { view.robot_from_camera.translation().z() = nan; });
  try_view([](RoomObservation& view) {
    view.robot_from_camera.linear() = Eigen::AngleAxisd(kPi / 2, Eigen::Vector3d::UnitY()).toRotationMatrix();
  });
  try_view([](RoomObservation& view) {
    view.robot_from_camera.linear() = Eigen::AngleAxisd(-kPi / 2, Eigen::Vector3d::UnitY()).toRotationMatrix();
  });
  try_view([](RoomObservation& view) { view.camera.height = 0; });
  robot.run(3.0);
  EXPECT_GT(robot.awareness.confidences().visible_tiles, 3) << "valid views are processed as before";
}

TEST(HostileViews, InvalidTimesDoNotCountAsTime) {
  test::ScanningRobot robot(test::PaintedRoom::colorful(1), {}, 1);
  robot.run(6.0);
  for (const double time : {robot.time, robot.time, -1e9, 1e9, std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity(), 0.0}) {
    RoomObservation view = robot.look();
    view.time = time;
    robot.awareness.update(view);
    expect_sound(robot.awareness.confidences());
  }
  for (const TileModel& tile : robot.awareness.model().tiles()) EXPECT_LT(tile.trained, 7.0);
  RoomObservation view = robot.look();
  view.odometry_rotation = std::numeric_limits<double>::quiet_NaN();
  robot.awareness.update(view);
  expect_sound(robot.awareness.confidences());
}

RC_GTEST_PROP(HostileViews, AnyParametersGiveValidConfidences, (std::uint64_t seed)) {
  const auto number = [](double low, double high) { return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0; };
  RoomParameters parameters = *rc::gen::arbitrary<bool>() ? test::paper_recipe() : RoomParameters{};
  parameters.distance.measure = *rc::gen::element(Distance::ssd3, Distance::ssd14, Distance::hellinger,
                                                  Distance::jensen_shannon, Distance::chi_square);
  parameters.wall.rows = *rc::gen::inRange(1, 9);
  parameters.wall.columns = *rc::gen::inRange(4, 129);
  parameters.wall.radius = number(1, 100);
  parameters.wall.top = number(0.1, 30);
  parameters.perception.bands = *rc::gen::inRange(8, 481);
  parameters.perception.sampled_rows = *rc::gen::inRange(8, 4097);
  parameters.view_filter.method = *rc::gen::element(ViewMethod::particles, ViewMethod::grid);
  parameters.view_filter.particles = *rc::gen::inRange(10, 300);
  parameters.view_filter.cells = *rc::gen::inRange(8, 361);
  parameters.view_filter.noise = number(0, 2);
  parameters.view_filter.leak = number(0.1, 1000);
  parameters.view_filter.sharpness = number(0, 5000);
  parameters.view_filter.injection = number(0, 10);
  parameters.confidence.time_constant = number(0, 3);
  parameters.background.trusted_after = 0.0;
  test::ScanningRobot robot(test::PaintedRoom::colorful(seed), parameters, seed);
  robot.truth = robot.belief = Pose2(number(-4, 4), number(-4, 4), number(-3, 3));
  robot.run(1.0);
  expect_sound(robot.awareness.confidences());
}

}  // namespace
}  // namespace reorient

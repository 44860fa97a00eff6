// SPDX-License-Identifier: MIT
#include "perception/room/wall/wall.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/perception/room/painted_room.h"

namespace reorient {
namespace {

double any_number(double low, double high) { return low + (high - low) * *rc::gen::inRange(0, 100001) / 100000.0; }

Pose2 any_pose() { return {any_number(-5, 5), any_number(-5, 5), any_number(-4, 4)}; }

TEST(Wall, HasAnEvenNumberOfColumns) {
  WallParameters parameters;
  parameters.columns = 31;
  EXPECT_EQ(Wall(parameters).columns(), 32);
}

TEST(Wall, ItsFirstTileBeginsBehindTheOpponentGoal) {
  const Wall wall;
  const auto ahead = wall.meet({0, 0, 0.5}, {1.0, 0.01, 0.1});
  ASSERT_TRUE(ahead);
  EXPECT_LT(ahead->column, 0.1);
  const auto left = wall.meet({0, 0, 0.5}, {0.0, 1.0, 0.1});
  ASSERT_TRUE(left);
  EXPECT_NEAR(left->column, 12.0, 1e-9);
  EXPECT_NEAR(left->row, (0.5 + 0.8 - 0.7) / 1.2, 1e-9);
}

RC_GTEST_PROP(Wall, ARayToAPointOfTheWallMeetsItThere, ()) {
  const Wall wall;
  const double column = any_number(0, 47.999);
  const double row = any_number(-1, 3);
  const Eigen::Vector3d eye(any_number(-5, 5), any_number(-5, 5), 0.5);
  const auto met = wall.meet(eye, (wall.point(column, row) - eye) * any_number(0.1, 3.0));
  RC_ASSERT(met);
  RC_ASSERT(std::abs(std::remainder(met->column - column, 48.0)) < 1e-6);
  RC_ASSERT(std::abs(met->row - row) < 1e-6);
}

RC_GTEST_PROP(Wall, TheReflectedPoseSeesTheReflectedTile, ()) {
  const Wall wall;
  const Pose2 pose = any_pose();
  const Isometry3 camera = test::standing_camera(any_number(-2, 2));
  const auto center = view_center(wall, pose, camera);
  const auto opposite = view_center(wall, reflect(pose), camera);
  RC_ASSERT(center && opposite);
  RC_ASSERT(std::abs(angle_difference(*opposite, *center + kPi)) < 1e-9);
  const int tile = *rc::gen::inRange(0, wall.tiles());
  const Eigen::Vector3d turned(-wall.center(tile).x(), -wall.center(tile).y(), wall.center(tile).z());
  RC_ASSERT((wall.center(wall.reflected(tile)) - turned).norm() < 1e-9);
  RC_ASSERT(wall.reflected(wall.reflected(tile)) == tile);
}

TEST(Wall, CornersAreInOrderAsSeenFromInside) {
  const Wall wall;
  const auto corners = wall.corners(wall.tile(1, 0));
  EXPECT_GT(corners[0].y(), corners[1].y()) << "corner 0 is on the left";
  EXPECT_NEAR(corners[0].z(), 1.9, 1e-9);
  EXPECT_NEAR(corners[3].z(), 3.1, 1e-9);
  EXPECT_NEAR(corners[2].y(), 0.0, 1e-9);
}

TEST(Wall, ARayFromOutsideOrStraightUpDoesNotMeetIt) {
  const Wall wall;
  EXPECT_FALSE(wall.meet({9, 0, 0.5}, {1, 0, 0}));
  EXPECT_FALSE(wall.meet({0, 0, 0.5}, {0, 0, 1}));
  EXPECT_FALSE(wall.meet({0, 0, 0.5}, {0, 0, 0}));
  EXPECT_FALSE(wall.azimuth_seen({8, 0}, 0.0));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(wall.meet({nan, 0, 0.5}, {1, 0, 0}));
  EXPECT_FALSE(wall.meet({0, 0, 0.5}, {nan, 0, 0}));
  EXPECT_FALSE(wall.azimuth_seen({0, 0}, nan));
  EXPECT_FALSE(view_center(wall, {0, 0, nan}, Isometry3::Identity()));
}

TEST(Wall, ManyAzimuthsAreTheSameAsOneByOne) {
  const Wall wall;
  const Eigen::Vector2d from(2.5, -1.5);
  std::vector<double> angles(37);
  for (std::size_t i = 0; i < angles.size(); ++i) angles[i] = -4.0 + 0.21 * static_cast<double>(i);
  std::vector<Eigen::Vector2d> headings(angles.size());
  std::vector<double> azimuths(angles.size());
  unit_vectors(angles, headings);
  wall.azimuths_seen(from, headings, azimuths);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    EXPECT_EQ(headings[i], unit_vector(angles[i]));
    EXPECT_EQ(azimuths[i], wall.azimuth_seen(from, angles[i]));
  }
}

TEST(Wall, PointsOfTilesMatchTheirAzimuth) {
  const Wall wall;
  for (const double column : {0.0, 0.5, 1.0, 7.3, 23.5, 47.5, 48.0, -1.0, 60.25}) {
    const Eigen::Vector2d expected = wall.radius() * unit_vector(column * wall.column_width());
    EXPECT_EQ(wall.point(column, 1.0).head<2>(), expected) << "column " << column;
  }
}

TEST(Wall, ExtremeNumbersStillGiveAWall) {
  WallParameters parameters;
  parameters.radius = -1.0;
  parameters.columns = 0;
  parameters.rows = 0;
  parameters.top = -5.0;
  const Wall wall(parameters);
  EXPECT_GT(wall.radius(), 0.0);
  EXPECT_GE(wall.tiles(), 2);
  EXPECT_GT(wall.row_height(), 0.0);
  for (const int columns : {129, 264, std::numeric_limits<int>::max()}) {
    parameters.columns = columns;
    EXPECT_EQ(Wall(parameters).columns(), kMostColumns);
  }
}

}  // namespace
}  // namespace reorient

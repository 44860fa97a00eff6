// SPDX-License-Identifier: MIT
// Images of real NAOs on real fields (SOURCES.md beside them). Where the cameras were was not recorded: the pitch of
// each was estimated from what is in the image (the center circle's size, a goal's height, a robot's height).
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "geometry/head.h"
#include "perception/field/field_features.h"
#include "tests/perception/field/percept_in.h"
#include "tests/perception/field/picture_file.h"
#include "tests/shared_data.h"

namespace reorient {
namespace {

struct RealImage {
  Image image;
  CameraModel camera;
  Isometry3 robot_from_camera;
};

RealImage old_robot(const std::filesystem::path& file, double pitch_degrees) {
  return {read_png(file), CameraModel::from_fields_of_view(640, 480, from_degrees(60.97), from_degrees(47.64)),
          robot_from_camera({}, {0.0, from_degrees(pitch_degrees)}, {}, RobotDimensions{}.torso_height)};
}

/// Line points whose pixel is within `tolerance` rows of the straight line from (x0, y0) to (x1, y1).
int points_along(const FieldPercept& percept, double x0, double y0, double x1, double y1, double tolerance) {
  int count = 0;
  for (const LinePoint& point : percept.line_points) {
    const double share = (point.pixel.x() - x0) / (x1 - x0);
    if (share < 0.0 || share > 1.0) continue;
    count += std::abs(point.pixel.y() - (y0 + share * (y1 - y0))) < tolerance ? 1 : 0;
  }
  return count;
}

class RealImages : public SharedDataTest {
 protected:
  RealImages() : SharedDataTest("images") {}
};

TEST_F(RealImages, ShowTheCenterCircleInADimHall) {
  const RealImage real = old_robot(folder() / "nao-v4-top-640x480-a.png", 20.7);
  FieldFeatures features({}, {});
  const FieldPercept percept = percept_in(features, real.image.view(), real.camera, real.robot_from_camera);
  EXPECT_GE(points_along(percept, 0, 103, 150, 95, 4), 5);  // halfway line
  EXPECT_GE(points_along(percept, 0, 127, 90, 124, 4), 6);  // the circle's near arc
  for (const LinePoint& point : percept.line_points) {      // nothing on the plain carpet, the ball, the boards
    EXPECT_LT(point.pixel.y(), 140.0f);
    EXPECT_GT(point.pixel.y(), 80.0f);
  }
  EXPECT_TRUE(percept.goal_posts.empty());
}

TEST_F(RealImages, ShowTouchlineHalfwayLineAndTheGoalBehind) {
  const RealImage real = old_robot(folder() / "nao-v4-top-640x480-b.png", 10.1);
  FieldFeatureParameters parameters;
  parameters.post_range = 9.0;
  FieldFeatures features(parameters, {});
  const FieldPercept percept = percept_in(features, real.image.view(), real.camera, real.robot_from_camera);
  EXPECT_GE(points_along(percept, 20, 266, 150, 196, 8), 15);   // touchline
  EXPECT_GE(points_along(percept, 150, 201, 480, 219, 5), 10);  // halfway line
  EXPECT_GE(points_along(percept, 490, 222, 640, 251, 8), 10);  // center circle
  ASSERT_FALSE(percept.goal_posts.empty());
  for (const GoalPost& post : percept.goal_posts) {
    EXPECT_TRUE(std::abs(post.base.x() - 367.0f) < 8.0f || std::abs(post.base.x() - 477.0f) < 8.0f) << post.base.x();
    EXPECT_NEAR(post.base.y(), 171.0f, 12.0f);
  }
}

TEST_F(RealImages, ShowACircleATouchlineAndARobotOnGrass) {
  const Image large = read_yuyv(folder() / "nao-v6-top-1280x960.yuyv.raw", 1280, 960, 36);
  const auto attitude = robot_from_camera({}, {0.0, from_degrees(17.4)}, {}, RobotDimensions{}.torso_height);
  for (Image image = large; image.width() >= 160; image = halved(image.view())) {
    SCOPED_TRACE(image.width());
    const double scale = image.width() / 640.0;
    const CameraModel camera =
        CameraModel::from_fields_of_view(image.width(), image.height(), from_degrees(56.3), from_degrees(43.7));
    FieldFeatures features({}, {});
    const FieldPercept percept = percept_in(features, image.view(), camera, attitude);
    EXPECT_GE(points_along(percept, 0, 140 * scale, 270 * scale, 110 * scale, 5 * scale + 1), 6);         // touchline
    EXPECT_GE(points_along(percept, 180 * scale, 407 * scale, 460 * scale, 402 * scale, 12 * scale), 5);  // circle
    ASSERT_GE(percept.obstacles.size(), 1u);
    const Obstacle& robot = percept.obstacles.front();
    EXPECT_NEAR(0.5 * (robot.left + robot.right), 325 * scale, 25 * scale);
    EXPECT_NEAR(robot.bottom, 163 * scale, 8 * scale);
    EXPECT_TRUE(percept.goal_posts.empty());
  }
}

}  // namespace
}  // namespace reorient

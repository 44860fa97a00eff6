// SPDX-License-Identifier: MIT
#include "perception/field/upright/ball_finder.h"

#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

#include "tests/perception/field/stand.h"

namespace reorient {
namespace {

/// A ball on plain carpet. A test adds to the percept what else was seen in the image.
class SeenBall : public testing::Test {
 protected:
  SeenBall() {
    scene.lines = false;
    scene.spheres = {{{0.2, 0.4}}};
    image = here.see(scene);
    color.observe(image.view(), view);
    map.fill(image.view(), color, std::max(0, static_cast<int>(view.highest_horizon())));
    percept.boundary.assign(CarpetMap::kColumns, 0.0f);
  }
  std::optional<Ball> found() const {
    return BallFinder({}, scene.field).find({image.view(), view, color}, map, KnownLines{}, percept);
  }

  FlatField scene;
  Stand here{640, 480, {-1.2, 0.3, 0.0}, {0.0, 0.25}};
  GroundProjection view = GroundProjection::look(here.camera, here.robot_from_camera).value();
  Image image;
  CarpetColor color{FieldFeatureParameters{}};
  CarpetMap map;
  FieldPercept percept;
};

TEST_F(SeenBall, IsFoundOnPlainCarpet) {
  const std::optional<Ball> ball = found();
  ASSERT_TRUE(ball);
  EXPECT_LT((here.field_from_robot * ball->position - scene.spheres[0].position).norm(), 0.08);
}

/// A rotating head blurs a line that leads away to the width of a ball.
TEST_F(SeenBall, IsNoBallIfALineIsInViewThere) {
  const std::optional<Ball> ball = found();
  ASSERT_TRUE(ball);
  LinePoint point;
  point.pixel = ball->pixel + Eigen::Vector2f(0.0f, 3.0f * ball->radius);
  percept.line_points.push_back(point);
  EXPECT_TRUE(found()) << "the line is in front of it";
  percept.line_points[0].pixel = ball->pixel + Eigen::Vector2f(0.0f, 0.1f * ball->radius);
  EXPECT_FALSE(found());
}

/// Whether a ball on the center circle is found from `pose`, if the vision knows the circle.
bool finds_ball_on_circle(const Eigen::Vector2d& ball, const Pose2& pose) {
  FlatField scene;
  scene.spheres = {{ball}};
  const Stand here(640, 480, pose, {0.0, 0.25});
  const GroundProjection view = GroundProjection::look(here.camera, here.robot_from_camera).value();
  const Image image = here.see(scene);
  CarpetColor color{FieldFeatureParameters{}};
  color.observe(image.view(), view);
  CarpetMap map;
  map.fill(image.view(), color, std::max(0, static_cast<int>(view.highest_horizon())));
  FieldPercept percept;
  percept.boundary.assign(CarpetMap::kColumns, 0.0f);
  KnownLines lines;
  lines.circle.emplace().center = pose.inverse() * Eigen::Vector2d::Zero();
  lines.circle_radius = scene.field.center_circle_radius;
  lines.line_width = scene.field.line_width;
  return BallFinder({}, scene.field).find({image.view(), view, color}, map, lines, percept).has_value();
}

/// The blurred end of the circle, seen from the side, is as wide as a ball.
TEST(BallOnTheCenterCircle, IsFoundUnlessTheLineCoversIt) {
  const double radius = FieldDimensions().center_circle_radius;
  EXPECT_TRUE(finds_ball_on_circle({-radius, 0.0}, {-radius - 1.2, 0.0, 0.0})) << "the line is across";
  EXPECT_FALSE(finds_ball_on_circle({0.0, radius}, {-1.2, radius, 0.0})) << "the line leads away behind it";
}

TEST_F(SeenBall, IsNoBallIfItBelongsToAnObstacle) {
  const std::optional<Ball> ball = found();
  ASSERT_TRUE(ball);
  const auto x = static_cast<int>(ball->pixel.x()), y = static_cast<int>(ball->pixel.y());
  percept.obstacles.push_back({.left = x + 60, .right = x + 100, .top = y - 200, .bottom = y + 20});
  EXPECT_TRUE(found()) << "the obstacle is beside it";
  percept.obstacles[0].left = x - 60;
  EXPECT_FALSE(found());
}

}  // namespace
}  // namespace reorient

// SPDX-License-Identifier: MIT
#include "perception/field/field_features.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/perception/field/filled_image.h"
#include "tests/perception/field/stand.h"
#include "tests/perception/field/turning_head.h"

namespace reorient {
namespace {

class FieldFeaturesAtEveryResolution : public testing::TestWithParam<int> {
 protected:
  Stand stand(const Pose2& pose, const HeadAngles& head = {0.0, 0.25}) const {
    return {GetParam(), GetParam() * 3 / 4, pose, head};
  }
};

TEST_P(FieldFeaturesAtEveryResolution, PutLinePointsOnTheLinesAround) {
  const FlatField scene;
  const Pose2 poses[] = {
      {-2.0, 0.0, 0.0}, {2.0, 0.5, 0.3}, {-3.2, 3.5, -0.5 * kPi}, {0.0, -1.5, 2.0}, {3.0, 1.0, -2.5}};
  for (const Pose2& pose : poses) {
    SCOPED_TRACE(testing::Message() << pose.position.transpose() << " " << pose.rotation);
    const Stand here = stand(pose);
    const FieldPercept percept = percept_of(scene, here);
    EXPECT_GE(percept.line_points.size(), 10u);
    expect_line_points_on_lines(percept, scene, here);
  }
}

TEST_P(FieldFeaturesAtEveryResolution, SeeNoLinePointsOnCarpetWithoutLines) {
  FlatField scene = FlatField::with_goals();
  scene.lines = false;
  for (const Pose2& pose : {Pose2{-2.0, 0.0, 0.0}, Pose2{2.5, 0.5, 0.1}, Pose2{3.0, 0.0, -0.2}}) {
    EXPECT_TRUE(percept_of(scene, stand(pose)).line_points.empty());
  }
}

TEST_P(FieldFeaturesAtEveryResolution, SeeBothPostsOfAGoalWhereTheyStand) {
  const FlatField scene = FlatField::with_goals();
  for (const double x : {1.0, 1.8, 2.4}) {
    const Stand here = stand({x, 0.0, 0.0}, {0.0, 0.1});
    const FieldPercept percept = percept_of(scene, here);
    ASSERT_EQ(percept.goal_posts.size(), 2u) << "from x = " << x;
    for (const GoalPost& post : percept.goal_posts) {
      const Eigen::Vector2d seen = here.field_from_robot * post.position;
      const Eigen::Vector2d real(4.5, std::copysign(0.8, seen.y()));
      EXPECT_TRUE(post.base_visible);
      EXPECT_LT((seen - real).norm(), 0.1 * (4.5 - x)) << seen.transpose();
    }
  }
}

TEST_P(FieldFeaturesAtEveryResolution, SeeTheBorderOfTheCarpet) {
  const FlatField scene;
  const Stand here = stand({0.0, 0.0, 0.0}, {0.0, 0.0});
  const FieldPercept percept = percept_of(scene, here);
  ASSERT_EQ(percept.boundary.size(), static_cast<std::size_t>(CarpetMap::kColumns));
  const auto border = here.camera.project(here.robot_from_camera.inverse() * Eigen::Vector3d(5.2, 0.0, 0.0));
  ASSERT_TRUE(border);
  EXPECT_NEAR(percept.boundary[CarpetMap::kColumns / 2], border->y(), 2.0 + here.camera.height / 240.0);
}

TEST_P(FieldFeaturesAtEveryResolution, SeeARobotAsAnObstacleAndNotAsAPost) {
  FlatField scene;
  scene.boxes.push_back({{2.0, 0.2}, 0.25, 0.55, {200, 126, 130}});
  const FieldPercept percept = percept_of(scene, stand({0.0, 0.0, 0.0}));
  EXPECT_TRUE(percept.goal_posts.empty());
  ASSERT_EQ(percept.obstacles.size(), 1u);
  EXPECT_NEAR(percept.obstacles[0].position.x(), 1.875, 0.2);
  EXPECT_NEAR(percept.obstacles[0].position.y(), 0.2, 0.1);
  for (const LinePoint& point : percept.line_points) {
    EXPECT_FALSE(point.pixel.x() > percept.obstacles[0].left && point.pixel.x() < percept.obstacles[0].right &&
                 point.pixel.y() < percept.obstacles[0].bottom);
  }
}

TEST_P(FieldFeaturesAtEveryResolution, SeeNothingWhenTheCameraLooksUpAtTheRoom) {
  EXPECT_TRUE(is_empty(percept_of(FlatField::with_goals(), stand({4.0, 0.0, 0.0}, {0.0, -0.67}))));
}

TEST_P(FieldFeaturesAtEveryResolution, SeeTheLinesUnderDimAndTintedLight) {
  FlatField scene;
  for (const auto& [gain, tint] : {std::pair{0.45, 0.0}, {1.2, 0.0}, {0.9, 0.06}, {0.9, -0.06}}) {
    const auto lit = [&, g = gain, t = tint](const Ycbcr& c) {
      return Ycbcr{static_cast<std::uint8_t>(std::min(255.0, g * c.y)),
                   static_cast<std::uint8_t>(128 + g * (c.cb - 128) - t * g * c.y),
                   static_cast<std::uint8_t>(128 + g * (c.cr - 128) + t * g * c.y)};
    };
    scene.colors = {lit(Colors{}.carpet), lit(Colors{}.line), lit(Colors{}.wall), lit(Colors{}.post)};
    const Stand here = stand({-2.0, 0.0, 0.0});
    const FieldPercept percept = percept_of(scene, here);
    EXPECT_GE(percept.line_points.size(), 10u) << gain << " " << tint;
    expect_line_points_on_lines(percept, scene, here);
  }
}

TEST_P(FieldFeaturesAtEveryResolution, SeeTheYellowGoalsOf2013) {
  FlatField scene = FlatField::with_goals();
  scene.field.yellow_goals = true;
  for (Box& post : scene.boxes) post.color = {150, 70, 140};
  const Stand here = stand({1.8, 0.0, 0.0}, {0.0, 0.1});
  EXPECT_EQ(percept_of(scene, here).goal_posts.size(), 2u);
  scene.field.yellow_goals = false;
  EXPECT_TRUE(percept_of(scene, here).goal_posts.empty());
}

TEST_P(FieldFeaturesAtEveryResolution, EstimateThePositionOfAPostWithItsFootBelowTheImage) {
  const FlatField scene = FlatField::with_goals();
  const Stand down = stand({3.0, 0.8, 0.0}, {0.0, 0.25});
  const Stand close = stand({3.6, 0.8, 0.0}, {0.0, -0.05});
  FieldFeatures features({}, scene.field);
  const Image carpet = down.see(scene);
  percept_in(features, carpet.view(), down.camera, down.robot_from_camera);
  const Image image = close.see(scene);
  const FieldPercept percept = percept_in(features, image.view(), close.camera, close.robot_from_camera);
  ASSERT_EQ(percept.goal_posts.size(), 1u);
  EXPECT_FALSE(percept.goal_posts[0].base_visible);
  EXPECT_NEAR(percept.goal_posts[0].position.x(), 0.9, 0.2);
  EXPECT_NEAR(percept.goal_posts[0].position.y(), 0.0, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Resolutions, FieldFeaturesAtEveryResolution, testing::Values(640, 320, 160));

TEST(FieldFeatures, SeePostsFarAwayDespiteAnErrorOfTheCamerasTilt) {
  const FlatField scene = FlatField::with_goals();
  for (const double x : {-1.5, -3.0, -4.2}) {
    for (const double tilt : {-1.5, 0.0, 1.5}) {
      SCOPED_TRACE(testing::Message() << "from x = " << x << ", " << tilt << " degrees");
      const Stand here(640, 480, {x, 0.0, 0.0}, {0.0, 0.1});
      const Stand thought(640, 480, {x, 0.0, 0.0}, {0.0, 0.1 + from_degrees(tilt)});
      FieldFeatures features({}, scene.field);
      const Image image = here.see(scene);
      const FieldPercept percept = percept_in(features, image.view(), here.camera, thought.robot_from_camera);
      ASSERT_EQ(percept.goal_posts.size(), 2u);
      for (const GoalPost& post : percept.goal_posts) {
        const Eigen::Vector2d real =
            Eigen::Vector2d(4.5, std::copysign(0.8, post.position.y())) - Eigen::Vector2d(x, 0);
        EXPECT_NEAR(direction_of(post.position), direction_of(real), from_degrees(1.0));
        EXPECT_NEAR(post.position.norm(), real.norm(), 0.12 * real.norm());
      }
    }
  }
}

TEST(FieldFeatures, DoNotMistakeAPoleFarAwayForAPost) {
  FlatField scene;
  scene.boxes = {{{4.5, 0.8}, 0.1, 2.5, scene.colors.post}, {{4.5, -0.8}, 0.1, 1.3, scene.colors.post}};
  for (const double x : {-1.5, -3.0}) {
    const FieldPercept percept = percept_of(scene, Stand(640, 480, {x, 0.0, 0.0}, {0.0, 0.1}));
    EXPECT_TRUE(percept.goal_posts.empty()) << "from x = " << x;
  }
}

TEST(FieldFeatures, DoNotMistakeALetterOnAGreenBannerForAPost) {
  const Stand here(640, 480, {3.6, 0.0, 0.0}, {0.0, 0.0});  // close to the border, with a wooden floor behind it
  const FlatField field;
  Image image = here.see(field);
  // Letters as tall as a post at 6 m, with their feet at the base of such a post.
  const auto pixel = [&](double x, double y, double z) {
    return *here.camera.project(here.robot_from_camera.inverse() * Eigen::Vector3d(x, y, z));
  };
  const auto foot = static_cast<int>(pixel(6.0, 0.0, 0.0).y()), top = static_cast<int>(pixel(6.0, 0.0, 0.8).y());
  const auto draw = [&](const Ycbcr& floor) {
    fill(image, 0, top - 20, 640, foot + 40, field.colors.carpet);
    fill(image, 0, foot + 40, 640, 480, floor);
    for (const double y : {0.5, -0.5}) {
      const double left = pixel(6.0, y + 0.05, 0.0).x(), right = pixel(6.0, y - 0.05, 0.0).x();
      fill(image, static_cast<int>(left), top, static_cast<int>(right), foot, {200, 126, 130});
    }
  };
  FieldFeatures features({}, field.field);
  const auto posts_on = [&](const Ycbcr& floor) {
    percept_in(features, here.see(field).view(), here.camera, here.robot_from_camera);  // learns the carpet
    draw(floor);
    return percept_in(features, image.view(), here.camera, here.robot_from_camera).goal_posts.size();
  };
  EXPECT_EQ(posts_on({110, 108, 150}), 0u);
  EXPECT_EQ(posts_on(field.colors.carpet), 2u) << "the same letters on carpet are posts";
}

TEST(FieldFeatures, SeeLinesWhileTheTorsoSways) {
  const FlatField scene;
  for (const double roll : {-0.15, 0.1}) {
    const Stand here(640, 480, {-2.0, 0.3, 0.1}, {0.3, 0.2}, {roll, 0.05});
    const FieldPercept percept = percept_of(scene, here);
    EXPECT_GE(percept.line_points.size(), 10u);
    expect_line_points_on_lines(percept, scene, here);
  }
}

TEST(FieldFeatures, SeeNearLinesThatLeadAwayWhileTheHeadTurns) {
  const FlatField scene;
  const Stand here(640, 480, {-0.45, 1.2, 0.5 * kPi}, {0.0, 0.3});  // the halfway line leads away on the right
  FieldFeatures features({}, scene.field);
  const Image image = seen_while_turning(here.see(scene), 16, 8.0);
  const FieldPercept percept = percept_in(features, image.view(), here.camera, here.robot_from_camera);
  expect_line_points_on_lines(percept, scene, here);
  const auto leads_away = [](const LinePoint& point) { return std::abs(std::sin(point.normal)) > 0.9; };
  EXPECT_GE(std::count_if(percept.line_points.begin(), percept.line_points.end(), leads_away), 8);
}

TEST(FieldFeatures, SeePostsThatLeanBecauseTheHeadTurns) {
  const FlatField scene = FlatField::with_goals();
  const Stand here(640, 480, {2.4, 0.0, 0.0}, {0.0, 0.1});
  FieldFeatures features({}, scene.field);
  for (const double skew : {-80.0, -40.0, 40.0, 80.0}) {  // pixels: up to a NAO's at 4 rad/s
    SCOPED_TRACE(skew);
    const Image image = seen_by_rolling_shutter(here.see(scene), skew);
    const FieldPercept percept = percept_in(features, image.view(), here.camera, here.robot_from_camera);
    EXPECT_EQ(percept.goal_posts.size(), 2u);
    for (const GoalPost& post : percept.goal_posts) {
      const Eigen::Vector2d seen = here.field_from_robot * post.position;
      EXPECT_LT((seen - Eigen::Vector2d(4.5, std::copysign(0.8, seen.y()))).norm(), 0.25) << seen.transpose();
    }
  }
}

TEST(FieldFeatures, SeeNothingFromTheGround) {
  const Stand upright(320, 240, {-2.0, 0.0, 0.0}, {0.0, 0.25});
  const Image image = upright.see(FlatField::with_goals());
  FieldFeatures features({}, {});
  for (const TorsoAttitude& torso : {TorsoAttitude{0.5 * kPi, 0.0}, TorsoAttitude{-0.5 * kPi, 0.0},
                                     TorsoAttitude{0.0, 0.5 * kPi}, TorsoAttitude{0.0, -0.5 * kPi}}) {
    EXPECT_TRUE(is_empty(percept_in(features, image.view(), upright.camera, robot_from_camera({}, {}, torso, 0.1))));
  }
}

TEST(FieldFeatures, AreTheSameForTheSameImages) {
  const Stand here(320, 240, {-1.0, 1.0, 0.4}, {0.0, 0.2});
  const Image image = here.see(FlatField::with_goals());
  FieldFeatures one({}, {});
  FieldFeatures other({}, {});
  const FieldPercept a = percept_in(one, image.view(), here.camera, here.robot_from_camera);
  const FieldPercept b = percept_in(other, image.view(), here.camera, here.robot_from_camera);
  ASSERT_EQ(a.line_points.size(), b.line_points.size());
  ASSERT_FALSE(a.line_points.empty());
  for (std::size_t i = 0; i < a.line_points.size(); ++i)
    EXPECT_EQ(a.line_points[i].position, b.line_points[i].position);
}

}  // namespace
}  // namespace reorient
